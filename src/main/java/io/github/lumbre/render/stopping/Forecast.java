package io.github.lumbre.render.stopping;

import io.github.lumbre.math.internal.Elementary;

/**
 * A forecast of the number of samples that a target error takes, from one error check.
 *
 * <p>The relative mean squared error decreases with the number of samples n as n^−1 where a pixel
 * is rough (edges, fireflies), and as n^−1.5 where it is smooth (Owen 1997). The first rate gives
 * the largest number of samples, the second the smallest.
 *
 * @param least smallest number of samples per pixel
 * @param most largest number of samples per pixel
 */
public record Forecast(double least, double most) {
  private static final double SMOOTH = 1.5;

  /**
   * Returns the forecast from a check. If the check has reached the target error, both numbers are
   * those so far.
   *
   * @param samples samples per pixel so far
   * @param targetError relative root mean squared error
   */
  static Forecast of(NoiseEstimate noise, double samples, double targetError) {
    double excess = Math.max(1, noise.upperRelativeMse() / (targetError * targetError));
    return new Forecast(samples * Elementary.pow(excess, 1 / SMOOTH), samples * excess);
  }

  /** Returns the geometric mean of the two numbers, as the likely value. */
  public double likely() {
    return Math.sqrt(least * most);
  }
}
