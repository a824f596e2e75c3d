package io.github.lumbre.lab.metrics;

import io.github.lumbre.math.internal.Elementary;

/** Student's t distribution. */
public final class StudentT {
  private static final int INTERVALS = 400;
  private static final int BISECTIONS = 50;

  private StudentT() {}

  /**
   * Returns the critical value t: |T| exceeds it with a probability of 1 − confidence.
   *
   * <p>With t = √ν·tan θ the density is proportional to cos^(ν−1) θ (Abramowitz &amp; Stegun 1964,
   * 26.7.1 with this substitution). The probability below t is then a ratio of two proper
   * integrals.
   *
   * @param confidence confidence level in (0,1)
   * @param degrees degrees of freedom ν, at least 1, not necessarily an integer
   */
  public static double critical(double confidence, double degrees) {
    double wanted = confidence * integral(Math.PI / 2, degrees);
    double low = 0;
    double high = Math.PI / 2;
    for (int i = 0; i < BISECTIONS; i++) {
      double middle = (low + high) / 2;
      if (integral(middle, degrees) < wanted) {
        low = middle;
      } else {
        high = middle;
      }
    }
    double turns = low / Elementary.TWO_PI;
    return Math.sqrt(degrees) * Elementary.sinTurns(turns) / Elementary.cosTurns(turns);
  }

  /** Returns the integral of cos^(ν−1) from 0 to an angle, by Simpson's rule. */
  private static double integral(double angle, double degrees) {
    double step = angle / INTERVALS;
    double sum = power(0, degrees) + power(angle, degrees);
    for (int i = 1; i < INTERVALS; i++) {
      sum += (i % 2 == 0 ? 2 : 4) * power(i * step, degrees);
    }
    return sum * step / 3;
  }

  private static double power(double angle, double degrees) {
    return Elementary.pow(Math.max(0, Elementary.cosTurns(angle / Elementary.TWO_PI)), degrees - 1);
  }
}
