package io.github.lumbre.camera;

import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.math.sampling.internal.Distribution1d;
import java.util.function.DoubleUnaryOperator;

/**
 * A pixel reconstruction filter: the density of a pixel's samples around its center. Each filter is
 * the product of the same function of x and of y.
 *
 * <p>Sample positions follow the filter, instead of weights (filter importance sampling; PBRT, 4th
 * edition, section 8.8). Every sample belongs to one pixel with weight 1, and a pixel is the mean
 * of its samples.
 */
public enum PixelFilter {
  /** The square of the pixel itself, with radius 0.5. */
  BOX(.5),

  /** A tent of radius 1. */
  TENT(1),

  /** A Gaussian with standard deviation 0.5, lowered to reach 0 at radius 1.5. */
  GAUSSIAN(1.5),

  /** The Blackman-Harris window (Harris 1978) with radius 1.5. */
  BLACKMAN_HARRIS(1.5);

  private final double radius;

  PixelFilter(double radius) {
    this.radius = radius;
  }

  /** The density of {@link #GAUSSIAN}, made when a render needs it. */
  private static final class Gaussian {
    static final Distribution1d TABLE = tabulated(PixelFilter::gaussian);
  }

  /** The density of {@link #BLACKMAN_HARRIS}, made when a render needs it. */
  private static final class BlackmanHarris {
    static final Distribution1d TABLE = tabulated(PixelFilter::blackmanHarris);
  }

  /**
   * Returns a piecewise constant density of 2048 cells, with the function's values at cell centers.
   */
  private static Distribution1d tabulated(DoubleUnaryOperator density) {
    double[] weights = new double[2048];
    for (int i = 0; i < weights.length; i++) {
      weights[i] = density.applyAsDouble((2 * i + 1.) / weights.length - 1);
    }
    return new Distribution1d(weights);
  }

  /**
   * Returns the unnormalized density of the Gaussian.
   *
   * @param t the offset from the center, in radii, in [-1,1]
   */
  static double gaussian(double t) {
    double deviations = 3 * t;
    return Elementary.exp(-.5 * deviations * deviations) - Elementary.exp(-4.5);
  }

  /**
   * Returns the unnormalized density of the four-term window with the lowest side lobes (Harris
   * 1978, table 1).
   *
   * @param t the offset from the center, in radii, in [-1,1]
   */
  static double blackmanHarris(double t) {
    return .35875
        + .48829 * Elementary.cosTurns(t / 2)
        + .14128 * Elementary.cosTurns(t)
        + .01168 * Elementary.cosTurns(3 * t / 2);
  }

  /** Returns the largest distance of samples from the pixel's center along x or y, in pixels. */
  public double radius() {
    return radius;
  }

  /**
   * Samples one coordinate of a film point.
   *
   * @param u uniform in [0,1)
   * @return the coordinate in pixels, relative to the pixel's left or top edge: the center is 0.5,
   *     and values are in [0.5 - radius, 0.5 + radius]; monotonic in u
   */
  public double sample(double u) {
    return switch (this) {
      case BOX -> u;
      case TENT -> u < .5 ? Math.sqrt(2 * u) - .5 : 1.5 - Math.sqrt(2 * (1 - u));
      case GAUSSIAN -> .5 + radius * sample(Gaussian.TABLE, u);
      case BLACKMAN_HARRIS -> .5 + radius * sample(BlackmanHarris.TABLE, u);
    };
  }

  /** Returns a number in [-1,1] that follows a density. */
  private static double sample(Distribution1d table, double u) {
    int cell = table.choose(u);
    return 2 * (cell + table.remainder(cell, u)) / table.size() - 1;
  }
}
