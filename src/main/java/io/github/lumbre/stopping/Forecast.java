package io.github.lumbre.stopping;

import io.github.lumbre.math.Elementary;

/**
 * How many samples a render will take to reach an error, estimated from one check.
 *
 * <p>The relative mean squared error falls with the number of samples to the power of −1 where a
 * pixel is rough (edges, fireflies), and to −1.5 where it is smooth (Owen 1997), so what the bound
 * still has to fall gives the most samples by the one and the least by the other.
 *
 * @param least samples per pixel
 * @param most samples per pixel
 */
public record Forecast(double least, double most) {
  private static final double SMOOTH = 1.5;

  /**
   * Returns the forecast from a look that has not reached the error.
   *
   * @param samples per pixel so far
   * @param targetError a relative root mean squared error
   */
  static Forecast of(NoiseEstimate noise, double samples, double targetError) {
    double excess = Math.max(1, noise.upperRelativeMse() / (targetError * targetError));
    return new Forecast(samples * Elementary.pow(excess, 1 / SMOOTH), samples * excess);
  }

  /** Returns the geometric mean of least and most. */
  public double likely() {
    return Math.sqrt(least * most);
  }
}
