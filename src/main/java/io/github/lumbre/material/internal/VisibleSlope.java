package io.github.lumbre.material.internal;

import io.github.lumbre.math.internal.Elementary;

/**
 * The distribution of visible slopes of a Beckmann surface with α = 1, along the viewing direction
 * (Heitz &amp; d'Eon 2014, "Importance Sampling Microfacet-Based BSDFs using the Distribution of
 * Visible Normals").
 *
 * <p>The density at slope x is proportional to {@code (cos θ − x sin θ) exp(−x²)} up to x = cot θ,
 * beyond which facets face away from the viewer.
 */
final class VisibleSlope {
  /** Slopes steeper than this have a total probability below 1e-36. */
  static final double STEEPEST = 9;

  private static final double INV_SQRT_PI = 0.5641895835477563;

  private static final int MAX_STEPS = 60;

  /**
   * The search ends after a step this small. A step of size d leaves an error of order d³, so
   * slopes are accurate to about 1e-8.
   */
  private static final double LAST_STEP = 2e-3;

  private static final int COSINES = 16;
  private static final int NUMBERS = 64;

  /** Slopes for a grid of cosines and uniform numbers: the starting points of the search. */
  private static final double[] GUESSES = new double[(COSINES + 1) * (NUMBERS + 1)];

  static {
    for (int row = 0; row <= COSINES; row++) {
      double cos = (double) row / COSINES;
      double sin = Math.sqrt(1 - cos * cos);
      double guess = -3;
      for (int column = 0; column <= NUMBERS; column++) {
        // At u = 0 and 1 the density vanishes. Use a nearby u, so that the search starts where the
        // density is positive.
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
   * @param cos cosine of the viewing angle θ, in [0,1]
   * @param sin sine of θ
   * @param u in [0,1]
   */
  static double at(double cos, double sin, double u) {
    return solve(cos, sin, u, guess(cos, u));
  }

  /** Returns a starting point, interpolated in the table. */
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
      // The derivative of the density, divided by the density, is −2x − sin / facing.
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

  /**
   * Returns the integral of {@code (cos − y sin) exp(−y²) / √π} over all y below x.
   *
   * @param bell exp(−x²)
   */
  static double cumulative(double cos, double sin, double x, double bell) {
    double tail = .5 * bell * Elementary.erfcScaled(Math.abs(x));
    return cos * (x < 0 ? tail : 1 - tail) + sin * .5 * INV_SQRT_PI * bell;
  }
}
