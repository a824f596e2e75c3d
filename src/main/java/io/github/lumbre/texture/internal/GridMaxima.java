package io.github.lumbre.texture.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.Texture;
import java.util.Arrays;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * The largest components of a bilinear texture at nine points of each cell of a grid: its corners,
 * the middles of its edges, and its center. They have the bits of {@link Texture#at(double,
 * double)}. Neighboring points share texels and interpolations along u, which are computed once for
 * each row of texels. Mutable; rows in ascending order are fastest.
 */
public final class GridMaxima {
  /** Points per axis of a cell. */
  private static final int POINTS = 3;

  private static final int CHANNELS = 3;

  /** A cell needs two rows of texels at a time, and three in all. */
  private static final int KEPT = 4;

  /** Columns whose numbers stay in the processor's first cache. */
  private static final int BLOCK = 1024;

  /** Rows that a thread computes at a time. */
  private static final int BAND = 256;

  private static final int NONE = -1;

  private final TexelRows texels;
  private final double[] tint;
  private final int columns;
  private final int rows;

  /** The texels left and right of each point along u, and the weight of the right one. */
  private final int[][] left = new int[POINTS][];

  private final int[][] right = new int[POINTS][];
  private final double[][] weights = new double[POINTS][];
  private final boolean[] isShifted = new boolean[POINTS];

  /** Rows of texels, interpolated at the points along u: by place, channel and point. */
  private final double[][][][] kept;

  private final int[] keptRows = new int[KEPT];
  private final double[] raw;
  private int next;

  /** Rows of texels that a texture interpolates bilinearly. */
  interface TexelRows {
    /** Returns the number of texels in a row. */
    int width();

    /** Returns the number of rows. */
    int height();

    /**
     * Reads a row.
     *
     * @param y the row, counted from the top
     * @param channel 0 red, 1 green, 2 blue
     * @param row receives a value for each texel
     */
    void read(int y, int channel, double[] row);
  }

  private GridMaxima(TexelRows texels, Rgb tint, int columns, int rows) {
    this.texels = texels;
    this.tint = new double[] {tint.r(), tint.g(), tint.b()};
    this.columns = columns;
    this.rows = rows;
    raw = new double[texels.width()];
    kept = new double[KEPT][CHANNELS][POINTS][columns];
    Arrays.fill(keptRows, NONE);
    for (int point = 0; point < POINTS; point++) {
      left[point] = new int[columns];
      right[point] = new int[columns];
      weights[point] = new double[columns];
      for (int column = 0; column < columns; column++) {
        Bilinear around = around(coordinate(column, point, columns), 0);
        left[point][column] = around.x0();
        right[point][column] = around.x1();
        weights[point][column] = around.s();
      }
      isShifted[point] = isShifted(point);
    }
  }

  /**
   * Returns the maxima of all cells, {@code [row][column]}; empty if the texture is none that
   * interpolates texels bilinearly. Uses the common pool of threads.
   *
   * @param columns number of cells along u
   * @param rows number of cells along v, from v = 0
   */
  public static Optional<double[][]> table(Texture<Rgb> texture, int columns, int rows) {
    if (of(texture, columns, rows).isEmpty()) {
      return Optional.empty();
    }
    double[][] table = new double[rows][];
    int bands = (rows + BAND - 1) / BAND;
    IntStream.range(0, bands)
        .parallel()
        .forEach(
            band -> {
              GridMaxima maxima = of(texture, columns, rows).orElseThrow();
              for (int row = band * BAND; row < Math.min(rows, (band + 1) * BAND); row++) {
                table[row] = new double[columns];
                maxima.read(row, table[row]);
              }
            });
    return Optional.of(table);
  }

  /**
   * Returns the maxima of a texture; empty if it is none that interpolates texels bilinearly.
   *
   * @param columns number of cells along u
   * @param rows number of cells along v
   */
  static Optional<GridMaxima> of(Texture<Rgb> texture, int columns, int rows) {
    if (texture instanceof ImageTexture image && image.filter() == ImageTexture.Filter.BILINEAR) {
      return Optional.of(new GridMaxima(image.texels(), image.tint(), columns, rows));
    }
    Texture<Rgb> plain = texture instanceof TintedTexture tinted ? tinted.texture() : texture;
    Rgb tint = texture instanceof TintedTexture tinted ? tinted.tint() : Rgb.WHITE;
    return plain instanceof LinearTexture linear
        ? Optional.of(new GridMaxima(linear.texels(), tint, columns, rows))
        : Optional.empty();
  }

  /**
   * Returns the coordinate of a point of a cell, just inside, so that an unfiltered neighbor does
   * not count.
   *
   * @param point 0, 1 or 2: at the beginning, in the middle or at the end of the cell
   */
  public static double coordinate(int cell, int point, int cells) {
    return (cell + .001 + .998 * (.5 * point)) / cells;
  }

  private Bilinear around(double u, double v) {
    return Bilinear.around(u, v, texels.width(), texels.height());
  }

  /**
   * Computes the maxima of a row of cells.
   *
   * @param row number of the row, from v = 0
   * @param maxima receives a number of at least 0 for each column
   */
  void read(int row, double[] maxima) {
    Arrays.fill(maxima, 0);
    for (int point = 0; point < POINTS; point++) {
      Bilinear around = around(0, coordinate(row, point, rows));
      double[][][] lower = line(around.y0(), NONE);
      double[][][] upper = line(around.y1(), around.y0());
      for (int from = 0; from < columns; from += BLOCK) {
        int to = Math.min(from + BLOCK, columns);
        for (int channel = 0; channel < CHANNELS; channel++) {
          for (int across = 0; across < POINTS; across++) {
            double[] below = lower[channel][across];
            raise(maxima, from, to, below, upper[channel][across], around.t(), tint[channel]);
          }
        }
      }
    }
  }

  private static void raise(
      double[] maxima, int from, int to, double[] lower, double[] upper, double t, double factor) {
    for (int i = from; i < to; i++) {
      maxima[i] = Math.max(maxima[i], factor * Bilinear.mix(lower[i], upper[i], t));
    }
  }

  /**
   * Returns a row of texels at the points along u.
   *
   * @param other a row that is to be kept
   */
  private double[][][] line(int y, int other) {
    for (int i = 0; i < KEPT; i++) {
      if (keptRows[i] == y) {
        return kept[i];
      }
    }
    if (other != NONE && keptRows[next] == other) {
      next = (next + 1) % KEPT;
    }
    double[][][] line = kept[next];
    keptRows[next] = y;
    next = (next + 1) % KEPT;
    for (int channel = 0; channel < CHANNELS; channel++) {
      texels.read(y, channel, raw);
      for (int point = 0; point < POINTS; point++) {
        interpolate(line[channel][point], point);
      }
    }
    return line;
  }

  private void interpolate(double[] line, int point) {
    int[] from = left[point];
    int[] to = right[point];
    double[] s = weights[point];
    // The first and the last texels may be neighbors across the border.
    int begin = isShifted[point] ? 1 : columns;
    for (int i = 0; i < Math.min(begin, columns); i++) {
      line[i] = Bilinear.mix(raw[from[i]], raw[to[i]], s[i]);
    }
    int shift = from[Math.min(1, columns - 1)] - 1;
    for (int i = begin; i < columns - 1; i++) {
      line[i] = Bilinear.mix(raw[i + shift], raw[i + shift + 1], s[i]);
    }
    for (int i = Math.max(begin, columns - 1); i < columns; i++) {
      line[i] = Bilinear.mix(raw[from[i]], raw[to[i]], s[i]);
    }
  }

  /** Returns whether all points but the first and the last have neighbors at one distance. */
  private boolean isShifted(int point) {
    for (int i = 1; i < columns - 1; i++) {
      int first = left[point][i];
      if (first - i != left[point][1] - 1 || right[point][i] != first + 1) {
        return false;
      }
    }
    return true;
  }
}
