package io.github.lumbre.material;

import java.util.function.DoubleUnaryOperator;

/**
 * Integrates by the double exponential rule (Takahasi &amp; Mori 1974), which stays accurate for
 * functions with infinite slopes at the ends of the interval.
 */
final class Quadrature {
  private static final double STEP = 1.0 / 16;
  private static final int POINTS = 52;

  private Quadrature() {}

  /**
   * Returns the integral of a bounded function that is smooth between the ends; 0 if they are
   * equal.
   */
  static double between(double from, double to, DoubleUnaryOperator f) {
    if (from == to) {
      return 0;
    }
    double sum = 0;
    for (int i = -POINTS; i <= POINTS; i++) {
      double s = .5 * Math.PI * Math.sinh(i * STEP);
      double cosh = Math.cosh(s);
      double weight = .5 * Math.PI * Math.cosh(i * STEP) / (cosh * cosh);
      // The weights of the two ends, each computed without cancellation.
      double share = 1 / (1 + Math.exp(-2 * s));
      double other = 1 / (1 + Math.exp(2 * s));
      sum += weight * f.applyAsDouble(from * other + to * share);
    }
    return .5 * STEP * (to - from) * sum;
  }
}
