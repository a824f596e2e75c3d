package io.github.lumbre.material;

import io.github.lumbre.math.Elementary;

/**
 * The distribution of the slopes, along the view, of those facets of a Beckmann surface with α = 1
 * that a viewer sees (Heitz &amp; d'Eon 2014, "Importance Sampling Microfacet-Based BSDFs using the
 * Distribution of Visible Normals").
 *
 * <p>Its density is proportional to {@code (cos θ − x sin θ) exp(−x²)} up to the slope cot θ, where
 * facets turn away.
 */
final class VisibleSlope {
  /** Slopes beyond this have a probability below 1e-36. */
  static final double STEEPEST = 9;

  private static final double INV_SQRT_PI = 0.5641895835477563;

  private static final int MAX_STEPS = 60;

  /**
   * After a step of size d an error of the order of d³ is left; so slopes are right to about 1e-8.
   */
  private static final double LAST_STEP = 2e-3;

  private static final int COSINES = 16;
  private static final int NUMBERS = 64;

  /** Slopes for a grid of cosines and of uniform numbers: where the search begins. */
  private static final double[] GUESSES = new double[(COSINES + 1) * (NUMBERS + 1)];

  static {
    for (int row = 0; row <= COSINES; row++) {
      double cos = (double) row / COSINES;
      double sin = Math.sqrt(1 - cos * cos);
      double guess = -3;
      for (int column = 0; column <= NUMBERS; column++) {
        // The distribution ends at 0 and 1; what matters there is to begin on its slope.
        double u = Math.max(.002, Math.min((double) column / NUMBERS, .998));
        guess = solve(cos, sin, u, guess);
        GUESSES[row * (NUMBERS + 1) + column] = guess;
      }
    }
  }

  private VisibleSlope() {}

  /**
   * Returns the slope at which the cumulative distribution is u.
   *
   * @param cos of the view's angle θ, in [0,1]
   * @param sin of the same angle
   * @param u in [0,1]
   */
  static double at(double cos, double sin, double u) {
    return solve(cos, sin, u, guess(cos, u));
  }

  /** Interpolates the table. */
  private static double guess(double cos, double u) {
    double row = cos * COSINES;
    double column = u * NUMBERS;
    int i = Math.min((int) row, COSINES - 1);
    int j = Math.min((int) column, NUMBERS - 1);
    int at = i * (NUMBERS + 1) + j;
    double low = GUESSES[at] + (column - j) * (GUESSES[at + 1] - GUESSES[at]);
    at += NUMBERS + 1;
    double high = GUESSES[at] + (column - j) * (GUESSES[at + 1] - GUESSES[at]);
    return low + (row - i) * (high - low);
  }

  /** Inverts the cumulative distribution by Halley's method inside a shrinking bracket. */
  private static double solve(double cos, double sin, double u, double guess) {
    double low = -STEEPEST;
    double high = STEEPEST;
    double total = cos;
    if (cos < STEEPEST * sin) {
      high = cos / sin;
      total = cumulative(cos, sin, high, Elementary.exp(-high * high));
    }
    double target = u * total;
    double x = guess > low && guess < high ? guess : .5 * (low + high);
    for (int i = 0; i < MAX_STEPS; i++) {
      double bell = Elementary.exp(-x * x);
      double excess = cumulative(cos, sin, x, bell) - target;
      if (excess > 0) {
        high = x;
      } else {
        low = x;
      }
      double facing = cos - x * sin;
      double newton = excess / (INV_SQRT_PI * bell * facing);
      // The density's derivative over the density is −2x − sin / facing.
      double next = x - newton / (1 + newton * (x + .5 * sin / facing));
      if (!(next >= low && next <= high)) {
        next = .5 * (low + high);
      }
      double step = Math.abs(next - x);
      x = next;
      if (step <= LAST_STEP && step * sin <= LAST_STEP * facing) {
        break;
      }
    }
    return x;
  }

  /** Returns the integral of {@code (cos − y sin) exp(−y²) / √π} over all y below x. */
  static double cumulative(double cos, double sin, double x, double bell) {
    double tail = .5 * bell * Elementary.erfcScaled(Math.abs(x));
    return cos * (x < 0 ? tail : 1 - tail) + sin * .5 * INV_SQRT_PI * bell;
  }
}
