package io.github.lumbre.math.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

/** Tests the accuracy of piecewise polynomials. */
class PiecewisePolynomialTest {
  /** The number of points from 0 to 1, inside every interval and on its ends. */
  private static final int POINTS = 6400;

  private static double largestError(DoubleUnaryOperator function) {
    PiecewisePolynomial polynomial = new PiecewisePolynomial(function);
    double largest = 0;
    for (int i = 0; i <= POINTS; i++) {
      double t = (double) i / POINTS;
      largest = Math.max(largest, Math.abs(polynomial.at(t) - function.applyAsDouble(t)));
    }
    return largest;
  }

  @Test
  void constantsAreKept() {
    assertThat(largestError(t -> 3)).isLessThan(1e-15);
  }

  /** Interpolation by polynomials of degree 7 reproduces those of every lower degree. */
  @Test
  void polynomialsUpToTheSeventhDegreeAreReproduced() {
    for (int degree = 1; degree <= 7; degree++) {
      int n = degree;
      assertThat(largestError(t -> StrictMath.pow(t - .3, n))).as("t^%d", n).isLessThan(1e-15);
    }
  }

  /** In an interval of 1/64, the higher terms of these functions' series are negligible. */
  @Test
  void smoothFunctionsAreKnownToRounding() {
    assertThat(largestError(t -> StrictMath.exp(t))).isLessThan(2e-15);
    assertThat(largestError(t -> StrictMath.sin(3 * t))).isLessThan(1e-15);
    assertThat(largestError(t -> 1 / (2 + t))).isLessThan(1e-15);
  }

  /** Each interval has its own polynomial, so functions may change at the ends. */
  @Test
  void intervalsDoNotKnowOfEachOther() {
    PiecewisePolynomial stairs = new PiecewisePolynomial(t -> Math.floor(64 * t));
    for (int interval = 0; interval < 64; interval++) {
      double middle = (interval + .5) / 64;
      assertThat(stairs.at(middle)).isCloseTo(interval, within(1e-12));
      assertThat(stairs.at(interval / 64.)).isCloseTo(interval, within(1e-12));
    }
    assertThat(stairs.at(1)).isCloseTo(63, within(1e-12));
  }

  @Test
  void functionIsAskedInsideTheUnitIntervalOnly() {
    new PiecewisePolynomial(
        t -> {
          assertThat(t).isStrictlyBetween(0.0, 1.0);
          return t;
        });
  }
}
