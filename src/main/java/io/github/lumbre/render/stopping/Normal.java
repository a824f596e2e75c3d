package io.github.lumbre.render.stopping;

import io.github.lumbre.math.internal.Elementary;

/** The standard normal distribution. */
final class Normal {
  private static final double FARTHEST = 38;
  private static final int BISECTIONS = 60;

  private Normal() {}

  /**
   * Returns the probability that a standard normal variable exceeds z.
   *
   * @param z at least 0
   */
  static double beyond(double z) {
    double x = z / Math.sqrt(2);
    return .5 * Elementary.erfcScaled(x) * Elementary.exp(-x * x);
  }

  /**
   * Returns the value z ≥ 0 that a standard normal variable exceeds with the given probability.
   *
   * @param probability in (0, 0.5]
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
