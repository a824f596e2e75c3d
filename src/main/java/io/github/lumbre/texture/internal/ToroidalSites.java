package io.github.lumbre.texture.internal;

/**
 * Points on a torus (a rectangle with joined opposite sides), sorted into a grid for
 * nearest-neighbor search. Immutable.
 */
final class ToroidalSites {
  /**
   * A tolerance well above the rounding of coordinates up to 2^14, and well below all relevant
   * distances.
   */
  private static final double ROUNDING = 1e-9;

  private final double width;
  private final double height;
  private final int columns;
  private final int rows;
  private final double cellWidth;
  private final double cellHeight;

  /** Cell c holds the sites from starts[c] to starts[c + 1] - 1 of the arrays below. */
  private final int[] starts;

  private final int[] indices;
  private final double[] xs;
  private final double[] ys;

  /**
   * Creates the sites; there must be at least one.
   *
   * @param x the x of each site, in [0, width]
   * @param y the y of each site, in [0, height]
   * @param width of the rectangle, up to {@value TexelTexture#MAX_SIDE}
   * @param height of the rectangle, up to {@value TexelTexture#MAX_SIDE}
   */
  ToroidalSites(double[] x, double[] y, double width, double height) {
    this.width = width;
    this.height = height;
    // Make cells nearly square, with about one site in each.
    rows = (int) Math.max(1, Math.min(x.length, Math.rint(Math.sqrt(x.length * height / width))));
    columns = Math.max(1, x.length / rows);
    cellWidth = width / columns;
    cellHeight = height / rows;
    int[] cellOf = new int[x.length];
    starts = new int[columns * rows + 1];
    for (int i = 0; i < x.length; i++) {
      cellOf[i] = row(y[i]) * columns + column(x[i]);
      starts[cellOf[i] + 1]++;
    }
    for (int c = 0; c < columns * rows; c++) {
      starts[c + 1] += starts[c];
    }
    int[] next = starts.clone();
    indices = new int[x.length];
    xs = new double[x.length];
    ys = new double[x.length];
    for (int i = 0; i < x.length; i++) {
      int place = next[cellOf[i]]++;
      indices[place] = i;
      xs[place] = x[i];
      ys[place] = y[i];
    }
  }

  private int column(double x) {
    return Math.min((int) (x / cellWidth), columns - 1);
  }

  private int row(double y) {
    return Math.min((int) (y / cellHeight), rows - 1);
  }

  /**
   * Returns the index of the site nearest to a point of the rectangle; the lowest index of equally
   * near sites.
   *
   * <p>Visits the cells around the point in growing squares. A site outside the square of radius r
   * is farther away than the square's nearest side. The search therefore ends when the best site is
   * nearer than that side.
   */
  int nearest(double x, double y) {
    Search search = new Search(x, y);
    int column = column(x);
    int row = row(y);
    double sideX = Math.min(x - column * cellWidth, (column + 1) * cellWidth - x);
    double sideY = Math.min(y - row * cellHeight, (row + 1) * cellHeight - y);
    for (int r = 0; ; r++) {
      search.ring(column, row, r);
      boolean allColumns = 2 * r + 1 >= columns;
      boolean allRows = 2 * r + 1 >= rows;
      double beyondX = allColumns ? Double.POSITIVE_INFINITY : sideX + r * cellWidth;
      double beyondY = allRows ? Double.POSITIVE_INFINITY : sideY + r * cellHeight;
      if (allColumns && allRows || search.isNearerThan(Math.min(beyondX, beyondY) - ROUNDING)) {
        return search.index;
      }
    }
  }

  /** A search and its best site so far. */
  private final class Search {
    private final double x;
    private final double y;
    private double squaredDistance = Double.POSITIVE_INFINITY;
    private int index = Integer.MAX_VALUE;

    Search(double x, double y) {
      this.x = x;
      this.y = y;
    }

    boolean isNearerThan(double distance) {
      return distance > 0 && squaredDistance < distance * distance;
    }

    /** Visits the cells of the square of radius r that are not in the square of radius r - 1. */
    void ring(int column, int row, int r) {
      int left = farthest(r, columns, true);
      int right = farthest(r, columns, false);
      for (int dy = -farthest(r, rows, true); dy <= farthest(r, rows, false); dy++) {
        int first = wrapped(row + dy, rows) * columns;
        if (Math.abs(dy) == r) {
          for (int dx = -left; dx <= right; dx++) {
            cell(first + wrapped(column + dx, columns));
          }
          continue;
        }
        if (left == r) {
          cell(first + wrapped(column - r, columns));
        }
        if (right == r) {
          cell(first + wrapped(column + r, columns));
        }
      }
    }

    private void cell(int cell) {
      for (int i = starts[cell]; i < starts[cell + 1]; i++) {
        double d = squaredDistance(xs[i] - x, ys[i] - y);
        if (d < squaredDistance || d == squaredDistance && indices[i] < index) {
          squaredDistance = d;
          index = indices[i];
        }
      }
    }
  }

  /**
   * Returns the largest offset, up to r, on one side, so that no cell is visited from both sides.
   */
  private static int farthest(int r, int cells, boolean before) {
    return Math.min(r, before ? (cells - 1) / 2 : cells / 2);
  }

  private static int wrapped(int i, int size) {
    return i < 0 ? i + size : i < size ? i : i - size;
  }

  private double squaredDistance(double dx, double dy) {
    double x = Math.min(Math.abs(dx), width - Math.abs(dx));
    double y = Math.min(Math.abs(dy), height - Math.abs(dy));
    return x * x + y * y;
  }
}
