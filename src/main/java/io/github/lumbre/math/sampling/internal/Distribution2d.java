package io.github.lumbre.math.sampling.internal;

import io.github.lumbre.math.Point2;
import java.util.stream.IntStream;

/**
 * A piecewise constant density over the unit square, proportional in each cell of a grid to the
 * cell's weight. Immutable.
 */
public final class Distribution2d {
  /** From here on, threads share the work. */
  private static final int MANY_ROWS = 256;

  private static final double BELOW_ONE = 0x1.fffffffffffffp-1;

  private final Distribution1d rows;
  private final Distribution1d[] columns;

  /**
   * Creates a distribution over a grid. For large grids, it uses the common pool of threads.
   *
   * @param weights {@code [row][column]}, row 0 at y = 0; each finite and ≥ 0; if all are 0, the
   *     distribution is uniform
   */
  public Distribution2d(double[][] weights) {
    columns = new Distribution1d[weights.length];
    double[] means = new double[weights.length];
    IntStream cells = IntStream.range(0, weights.length);
    boolean isLarge = weights.length > MANY_ROWS;
    (isLarge ? cells.parallel() : cells)
        .forEach(
            row -> {
              columns[row] = new Distribution1d(weights[row]);
              means[row] = columns[row].mean();
            });
    rows = new Distribution1d(means);
  }

  /**
   * A point sampled from the density.
   *
   * @param x in [0,1)
   * @param y in [0,1)
   * @param pdf density of the selected cell, per unit area of the square; always positive, even if
   *     rounding moved the point onto the border of a cell of density 0
   */
  public record Sample(double x, double y, double pdf) {
    public Point2 point() {
      return new Point2(x, y);
    }
  }

  /**
   * Returns a point of the square sampled from the density.
   *
   * @param u uniform in [0,1)²
   */
  public Sample sample(Point2 u) {
    int row = rows.choose(u.y());
    Distribution1d cells = columns[row];
    int column = cells.choose(u.x());
    double x = (column + cells.remainder(column, u.x())) / cells.size();
    double y = (row + rows.remainder(row, u.y())) / rows.size();
    return new Sample(Math.min(x, BELOW_ONE), Math.min(y, BELOW_ONE), pdf(row, column));
  }

  /** Returns the probability of a cell of the grid. */
  public double probability(int row, int column) {
    return rows.probability(row) * columns[row].probability(column);
  }

  /** Returns the density at a point of the square, per unit area of the square. */
  public double pdf(Point2 p) {
    int row = Math.min((int) (p.y() * rows.size()), rows.size() - 1);
    int size = columns[row].size();
    return pdf(row, Math.min((int) (p.x() * size), size - 1));
  }

  private double pdf(int row, int column) {
    Distribution1d cells = columns[row];
    return rows.probability(row) * rows.size() * cells.probability(column) * cells.size();
  }
}
