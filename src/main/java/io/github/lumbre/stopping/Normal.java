package io.github.lumbre.stopping;

import io.github.lumbre.math.Elementary;

/** The standard normal distribution. */
final class Normal {
  private static final double FARTHEST = 38;
  private static final int BISECTIONS = 60;

  private Normal() {}

  /** Returns the probability of more than z, for z of at least 0. */
  static double beyond(double z) {
    double x = z / Math.sqrt(2);
    return .5 * Elementary.erfcScaled(x) * Elementary.exp(-x * x);
  }

  /**
   * Returns the z of at least 0 that is exceeded with a probability.
   *
   * @param probability in (0, .5]
   */
  static double exceeded(double probability) {
    double low = 0;
    double high = FARTHEST;
    for (int i = 0; i < BISECTIONS; i++) {
      double middle = .5 * (low + high);
      if (beyond(middle) > probability) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return .5 * (low + high);
  }
}
