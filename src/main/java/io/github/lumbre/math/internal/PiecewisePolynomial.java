package io.github.lumbre.math.internal;

import java.util.function.DoubleUnaryOperator;

/**
 * A smooth function on [0,1], approximated by one polynomial on each of 64 equal intervals. It
 * takes a few multiplications instead of a long series and is bit-identical on every machine.
 * Immutable.
 *
 * <p>Each polynomial interpolates the function at the Chebyshev points of its interval. For
 * functions without a singularity near [0,1], the approximation error is below the rounding error
 * of the result.
 */
final class PiecewisePolynomial {
  private static final int INTERVALS = 64;
  private static final int COEFFICIENTS = 8;

  /** Coefficients of s^0 to s^7 for each interval, with s from −0.5 to 0.5. */
  private final double[] coefficients = new double[INTERVALS * COEFFICIENTS];

  PiecewisePolynomial(DoubleUnaryOperator function) {
    double[] s = new double[COEFFICIENTS];
    double[] values = new double[COEFFICIENTS];
    for (int interval = 0; interval < INTERVALS; interval++) {
      for (int i = 0; i < COEFFICIENTS; i++) {
        s[i] = .5 * Elementary.cosDegrees(180 * (i + .5) / COEFFICIENTS);
        values[i] = function.applyAsDouble((interval + .5 + s[i]) / INTERVALS);
      }
      double[] polynomial = interpolating(s, values);
      System.arraycopy(polynomial, 0, coefficients, interval * COEFFICIENTS, COEFFICIENTS);
    }
  }

  /** Returns the coefficients of the polynomial through points, by Newton's divided differences. */
  private static double[] interpolating(double[] s, double[] values) {
    int n = s.length;
    double[] differences = values.clone();
    for (int order = 1; order < n; order++) {
      for (int i = n - 1; i >= order; i--) {
        differences[i] = (differences[i] - differences[i - 1]) / (s[i] - s[i - order]);
      }
    }
    double[] polynomial = new double[n];
    for (int i = n - 1; i >= 0; i--) {
      // Multiply by (s − s[i]) and add the next difference.
      for (int power = n - 1; power > 0; power--) {
        polynomial[power] = polynomial[power - 1] - s[i] * polynomial[power];
      }
      polynomial[0] = differences[i] - s[i] * polynomial[0];
    }
    return polynomial;
  }

  /** Returns the function's value at t in [0,1]. */
  double at(double t) {
    double scaled = t * INTERVALS;
    int interval = Math.min((int) scaled, INTERVALS - 1);
    double s = scaled - interval - .5;
    double[] c = coefficients;
    int i = interval * COEFFICIENTS;
    double s2 = s * s;
    // Two independent chains of operations take half the time of one.
    double even =
        FusedMultiplyAdd.of(
            FusedMultiplyAdd.of(FusedMultiplyAdd.of(c[i + 6], s2, c[i + 4]), s2, c[i + 2]),
            s2,
            c[i]);
    double odd =
        FusedMultiplyAdd.of(
            FusedMultiplyAdd.of(FusedMultiplyAdd.of(c[i + 7], s2, c[i + 5]), s2, c[i + 3]),
            s2,
            c[i + 1]);
    return FusedMultiplyAdd.of(s, odd, even);
  }
}
