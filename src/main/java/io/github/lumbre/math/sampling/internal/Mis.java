package io.github.lumbre.math.sampling.internal;

/** The heuristics of multiple importance sampling (Veach 1997, ch. 9). */
public final class Mis {
  private Mis() {}

  /**
   * Returns the power heuristic's weight in [0,1], with exponent 2, for a sample that another
   * technique could also have drawn. If {@code other} is 0, the weight is 1; if both densities are
   * infinite, it is 0.5.
   *
   * @param own density of the technique that drew the sample, &gt; 0
   * @param other density of the other technique for the same sample, at least 0
   */
  public static double power(double own, double other) {
    // Use ratios, so that squares of extreme densities neither overflow nor underflow.
    if (own > other) {
      double r = other / own;
      return 1 / (1 + r * r);
    }
    if (own == other) {
      return .5;
    }
    double r = own / other;
    return r * r / (1 + r * r);
  }

  /**
   * Returns the balance heuristic's weight in [0,1] for a sample that another technique could also
   * have drawn. If {@code other} is 0, the weight is 1; if both densities are infinite, it is 0.5.
   *
   * @param own density of the technique that drew the sample, &gt; 0
   * @param other density of the other technique for the same sample, at least 0
   */
  public static double balance(double own, double other) {
    if (own > other) {
      return 1 / (1 + other / own);
    }
    if (own == other) {
      return .5;
    }
    double r = own / other;
    return r / (1 + r);
  }
}
