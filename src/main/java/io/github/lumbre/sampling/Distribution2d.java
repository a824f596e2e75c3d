package io.github.lumbre.sampling;

import io.github.lumbre.math.Point2;

/**
 * A density over the unit square, constant in each cell of a grid and proportional to its weight.
 * Immutable.
 */
public final class Distribution2d {
  private final Distribution1d rows;
  private final Distribution1d[] columns;

  /**
   * @param weights {@code [row][column]}, row 0 at y = 0; each finite and ≥ 0
   */
  public Distribution2d(double[][] weights) {
    columns = new Distribution1d[weights.length];
    double[] sums = new double[weights.length];
    for (int row = 0; row < weights.length; row++) {
      columns[row] = new Distribution1d(weights[row]);
      sums[row] = columns[row].sum();
    }
    rows = new Distribution1d(sums);
  }

  /** Returns a point of the square, drawn from the density by a uniform one. */
  public Point2 sample(Point2 u) {
    int row = rows.choose(u.y());
    Distribution1d cells = columns[row];
    int column = cells.choose(u.x());
    return new Point2(
        (column + cells.remainder(column, u.x())) / cells.size(),
        (row + rows.remainder(row, u.y())) / rows.size());
  }

  /** Returns the density at a point of the square, per unit of its area. */
  public double pdf(Point2 p) {
    int row = Math.min((int) (p.y() * rows.size()), rows.size() - 1);
    Distribution1d cells = columns[row];
    int column = Math.min((int) (p.x() * cells.size()), cells.size() - 1);
    return rows.probability(row) * rows.size() * cells.probability(column) * cells.size();
  }
}
