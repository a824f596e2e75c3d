package io.github.lumbre.sampling;

/** Multiple importance sampling (Veach 1997, ch. 9). */
public final class Mis {
  private Mis() {}

  /**
   * Returns the power heuristic's weight (exponent 2) of a sample drawn with density {@code own},
   * when another technique could have drawn it with density {@code other}; 1 if the other is 0, ½
   * if both are infinite.
   */
  public static double power(double own, double other) {
    // Ratios, so that squares of extreme densities neither overflow nor vanish.
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
   * Returns the balance heuristic's weight of a sample drawn with density {@code own}, when another
   * technique could have drawn it with density {@code other}; 1 if the other is 0, ½ if both are
   * infinite.
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
