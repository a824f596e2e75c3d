package io.github.lumbre.testing;

import io.github.lumbre.math.Vec3;
import java.util.Arrays;
import java.util.Comparator;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;

/**
 * The outcome of Pearson's χ² test: whether counts follow an expected density.
 *
 * @param statistic Σ(observed − expected)²/expected
 * @param degrees of freedom: cells after pooling, less one
 * @param impossible samples counted where none was to be expected at all
 */
public record ChiSquare(double statistic, int degrees, long impossible) {
  /** One-sided quantile of the standard normal distribution at 1 − {@link Statistics#ALPHA}. */
  private static final double Z_ALPHA = 4.75342;

  private static final double SMALLEST_CELL = 5;

  /** The maximum relative difference between the sums of the expected numbers and of the counts. */
  private static final double NORMALIZATION = 2e-3;

  /** The grid of {@link #ofDirections}: odd rows, so that the horizon splits a cell. */
  private static final int ROWS = 41;

  private static final int COLUMNS = 80;

  /** Returns whether the counts follow the expectation, at {@link Statistics#ALPHA}. */
  public boolean passes() {
    boolean passes = impossible == 0 && statistic <= critical(degrees);
    if (passes) {
      // Planted defects fail here, and must not enter the figures of the run.
      Figures.worst("chi-square as z", deviate());
    }
    return passes;
  }

  /** Returns the statistic as a normal deviate, the inverse of {@link #critical}. */
  private double deviate() {
    double v = 2.0 / (9.0 * degrees);
    return (Math.cbrt(statistic / degrees) - 1 + v) / Math.sqrt(v);
  }

  /**
   * Returns the value that the statistic exceeds with a probability of {@link Statistics#ALPHA}
   * (Wilson &amp; Hilferty 1931: accurate to 0.1 % from 100 degrees on, too high for few degrees).
   */
  public static double critical(int degrees) {
    double v = 2.0 / (9.0 * degrees);
    double root = 1 - v + Z_ALPHA * Math.sqrt(v);
    return degrees * root * root * root;
  }

  /**
   * Tests counts. Cells with fewer than 5 expected samples are pooled, smallest first; the expected
   * numbers are scaled by at most 0.2 % to the sum of the counts.
   *
   * @param expected a number for each count, ≥ 0
   * @throws IllegalArgumentException if the sums differ by more, or fewer than two cells remain
   */
  public static ChiSquare of(long[] counts, double[] expected) {
    double samples = Arrays.stream(counts).sum();
    double sum = Arrays.stream(expected).sum();
    if (!(Math.abs(sum / samples - 1) <= NORMALIZATION)) {
      throw new IllegalArgumentException(
          "expected: expected a sum of " + samples + ", found " + sum);
    }
    Integer[] order = new Integer[counts.length];
    Arrays.setAll(order, i -> i);
    Arrays.sort(order, Comparator.comparingDouble(i -> expected[i]));
    double statistic = 0;
    int cells = 0;
    long impossible = 0;
    double pooled = 0;
    long counted = 0;
    for (int i : order) {
      if (expected[i] == 0) {
        impossible += counts[i];
        continue;
      }
      pooled += expected[i] * (samples / sum);
      counted += counts[i];
      if (pooled >= SMALLEST_CELL) {
        statistic += (counted - pooled) * (counted - pooled) / pooled;
        cells++;
        pooled = 0;
        counted = 0;
      }
    }
    if (cells < 2) {
      throw new IllegalArgumentException(
          "cells: expected at least 2 after pooling, found " + cells);
    }
    return new ChiSquare(statistic, cells - 1, impossible);
  }

  /** Tests counts against one expectation for all cells. */
  public static ChiSquare uniform(long[] counts) {
    double[] expected = new double[counts.length];
    Arrays.fill(expected, (double) Arrays.stream(counts).sum() / counts.length);
    return of(counts, expected);
  }

  /**
   * Tests directions against their density per solid angle, in 41 × 80 cells of equal solid angle.
   * A direction of density 0 is impossible.
   *
   * @param directions unit directions, or empty if nothing was sampled; empty ones count as
   *     samples, so the density has to sum to 1 minus their fraction
   * @param pdf smooth enough for {@code points}² midpoints per cell
   */
  public static ChiSquare ofDirections(
      int samples, Supplier<Optional<Vec3>> directions, ToDoubleFunction<Vec3> pdf, int points) {
    long[] counts = new long[ROWS * COLUMNS + 1];
    long impossible = 0;
    for (int i = 0; i < samples; i++) {
      Optional<Vec3> direction = directions.get();
      counts[direction.map(ChiSquare::cell).orElse(ROWS * COLUMNS)]++;
      if (direction.isPresent() && !(pdf.applyAsDouble(direction.get()) > 0)) {
        impossible++;
      }
    }
    double[] expected = new double[counts.length];
    for (int cell = 0; cell < ROWS * COLUMNS; cell++) {
      expected[cell] = samples * integral(cell, pdf, points);
    }
    expected[ROWS * COLUMNS] = counts[ROWS * COLUMNS];
    ChiSquare test = of(counts, expected);
    return new ChiSquare(test.statistic, test.degrees, test.impossible + impossible);
  }

  private static int cell(Vec3 d) {
    int row = Math.min((int) ((d.z() + 1) / 2 * ROWS), ROWS - 1);
    double turns = Math.atan2(d.y(), d.x()) / (2 * Math.PI) + .5;
    return row * COLUMNS + Math.min((int) (turns * COLUMNS), COLUMNS - 1);
  }

  private static double integral(int cell, ToDoubleFunction<Vec3> pdf, int points) {
    double sum = 0;
    for (int i = 0; i < points; i++) {
      double z = 2 * (cell / COLUMNS + (i + .5) / points) / ROWS - 1;
      double s = Math.sqrt(1 - z * z);
      for (int j = 0; j < points; j++) {
        double phi = 2 * Math.PI * ((cell % COLUMNS + (j + .5) / points) / COLUMNS - .5);
        sum += pdf.applyAsDouble(new Vec3(s * Math.cos(phi), s * Math.sin(phi), z));
      }
    }
    return sum * 4 * Math.PI / (ROWS * COLUMNS) / (points * points);
  }
}
