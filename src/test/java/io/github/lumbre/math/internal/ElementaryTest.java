package io.github.lumbre.math.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the accuracy of elementary functions in ulp. */
class ElementaryTest {
  private static final double EPS = 0x1p-52;

  /** The difference between 2π and its nearest double. */
  private static final double TWO_PI_REST = 2.4492935982947064e-16;

  private final SplittableRandom random = new SplittableRandom(3);

  private static void assertWithinTwoUlp(double actual, double expected) {
    assertThat(Math.abs(actual - expected)).isLessThanOrEqualTo(2 * Math.ulp(expected));
  }

  @Test
  void kernelsAreRightToTwoUlp() {
    for (int i = 0; i < 100_000; i++) {
      double x = random.nextDouble(-Math.PI / 4, Math.PI / 4);
      assertWithinTwoUlp(Elementary.sinSmall(x), StrictMath.sin(x));
      assertWithinTwoUlp(Elementary.cosSmall(x), StrictMath.cos(x));
    }
    for (double x = 1; x > 1e-300; x /= 10) {
      assertWithinTwoUlp(Elementary.sinSmall(.78 * x), StrictMath.sin(.78 * x));
    }
  }

  /**
   * The reference computes the angle with twice the precision, because 2π and the product are
   * rounded.
   */
  @Test
  void turnsAreRightToTwoUlp() {
    for (int i = 0; i < 100_000; i++) {
      double part = random.nextDouble(-.125, .125);
      double turns = part + .25 * random.nextInt(-3, 4);
      part = turns - .25 * Math.rint(4 * turns);
      double angle = part * Elementary.TWO_PI;
      double rest = Math.fma(part, Elementary.TWO_PI, -angle) + part * TWO_PI_REST;
      double sin = StrictMath.sin(angle) + rest * StrictMath.cos(angle);
      double cos = StrictMath.cos(angle) - rest * StrictMath.sin(angle);
      int quarter = Math.floorMod((int) Math.rint(4 * turns), 4);
      double[] expected = {sin, cos, -sin, -cos, sin};
      assertWithinTwoUlp(Elementary.sinTurns(turns), expected[quarter]);
      assertWithinTwoUlp(Elementary.cosTurns(turns), expected[quarter + 1]);
    }
  }

  @Test
  void quarterTurnsAreExact() {
    double[] sines = {0, 1, 0, -1, 0};
    for (int quarters = -4000; quarters <= 4000; quarters++) {
      int quarter = Math.floorMod(quarters, 4);
      // Adding 0 makes a negative zero positive.
      assertThat(Elementary.sinTurns(quarters / 4.0) + 0.0).isEqualTo(sines[quarter]);
      assertThat(Elementary.cosTurns(quarters / 4.0) + 0.0).isEqualTo(sines[quarter + 1]);
      assertThat(Elementary.sinDegrees(quarters * 90.0) + 0.0).isEqualTo(sines[quarter]);
      assertThat(Elementary.cosDegrees(quarters * 90.0) + 0.0).isEqualTo(sines[quarter + 1]);
    }
  }

  @Test
  void largeAnglesAreReducedExactly() {
    assertThat(Elementary.sinTurns(0x1p40 + .0625)).isEqualTo(Elementary.sinTurns(.0625));
    for (double turns : new double[] {0x1p52 + 1, 0x1p61 + 0x1p10, 1e22, 1e300, -1e308}) {
      assertThat(Elementary.sinTurns(turns)).isZero();
      assertThat(Elementary.cosTurns(turns)).isEqualTo(1);
    }
    assertThat(Elementary.sinDegrees(360e9 + 30)).isEqualTo(Elementary.sinDegrees(30));
    assertThat(Elementary.cosDegrees(-360e9 + 30)).isEqualTo(Elementary.cosDegrees(30));
  }

  @Test
  void degreesAreRightToTwoUlpNearTheZerosToo() {
    assertWithinTwoUlp(Elementary.sinDegrees(30), .5);
    assertWithinTwoUlp(Elementary.cosDegrees(60), .5);
    assertWithinTwoUlp(Elementary.sinDegrees(45), Math.sqrt(.5));
    double small = 0x1p-30;
    double sine = StrictMath.sin(small * (Math.PI / 180));
    assertWithinTwoUlp(Elementary.sinDegrees(small), sine);
    assertWithinTwoUlp(Elementary.cosDegrees(90 - small), sine);
    assertWithinTwoUlp(Elementary.sinDegrees(180 - small), sine);
    assertWithinTwoUlp(Elementary.cosDegrees(-90 + small), sine);
  }

  @Test
  void squaresOfSineAndCosineSumToOne() {
    for (int i = 0; i < 10_000; i++) {
      double turns = random.nextDouble(-10, 10);
      double s = Elementary.sinTurns(turns);
      double c = Elementary.cosTurns(turns);
      assertThat(s * s + c * c).isCloseTo(1, within(3 * EPS));
    }
  }

  @Test
  void anglesAreRightToFourUlp() {
    for (int i = 0; i < 300_000; i++) {
      double y = random.nextDouble(-1, 1) * Math.pow(10, random.nextInt(-6, 3));
      double x = random.nextDouble(-1, 1) * Math.pow(10, random.nextInt(-6, 3));
      double expected = StrictMath.atan2(y, x);
      assertThat(Math.abs(Elementary.atan2(y, x) - expected))
          .isLessThanOrEqualTo(4 * Math.ulp(expected));
      double sine = i % 2 == 0 ? x / 1000 : Math.copySign(1 - Math.abs(x / 1000), x);
      double angle = StrictMath.asin(sine);
      assertThat(Math.abs(Elementary.asin(sine) - angle)).isLessThanOrEqualTo(4 * Math.ulp(angle));
    }
  }

  @Test
  void anglesOnAndNearTheAxesKeepTheirQuadrants() {
    double[] coordinates = {0.0, -0.0, 1, -1, 1e300, -1e300, 1e-300, Double.MIN_VALUE};
    for (double x : coordinates) {
      for (double y : coordinates) {
        double expected = StrictMath.atan2(y, x);
        assertThat(Elementary.atan2(y, x)).isCloseTo(expected, within(Math.ulp(expected)));
        assertThat(Math.copySign(1, Elementary.atan2(y, x))).isEqualTo(Math.copySign(1, y));
      }
    }
  }

  @Test
  void arcSineToleratesRounding() {
    assertThat(Elementary.asin(1 + EPS)).isEqualTo(Math.PI / 2);
    assertThat(Elementary.asin(-1 - EPS)).isEqualTo(-Math.PI / 2);
    assertThat(Elementary.safeSqrt(-EPS)).isZero();
    assertThat(Elementary.safeSqrt(4)).isEqualTo(2);
  }

  @Test
  void exponentialIsRightToTwoUlp() {
    SplittableRandom random = new SplittableRandom(17);
    for (int i = 0; i < 1_000_000; i++) {
      double x = i % 2 == 0 ? random.nextDouble(-745, 709) : random.nextDouble(-2, 2);
      double expected = StrictMath.exp(x);
      assertThat(Math.abs(Elementary.exp(x) - expected))
          .isLessThanOrEqualTo(2 * Math.ulp(expected));
    }
    assertThat(Elementary.exp(0)).isEqualTo(1);
    assertThat(Elementary.exp(710)).isInfinite();
    assertThat(Elementary.exp(-746)).isZero();
    assertThat(Elementary.exp(Double.POSITIVE_INFINITY)).isInfinite();
    assertThat(Elementary.exp(Double.NEGATIVE_INFINITY)).isZero();
    assertThat(Elementary.exp(Double.NaN)).isNaN();
  }

  /** References by series and continued fractions with 60 digits. */
  @ParameterizedTest
  @CsvSource({
    "0, 1",
    "1e-12, .99999999999887162083",
    ".001, .9988726200811514086",
    ".1, .89645697996912663666",
    ".5, .61569034419292587487",
    "1, .42758357615580700441",
    "2, .25539567631050574387",
    "3.7, .14743499753718507247",
    "5, .11070463773306862637",
    "9, .062307724037774684147",
    "20, .028174348741051319319",
    "1000, .0005641893014533876542",
    "1e8, 5.6418958354775625874e-9",
  })
  void scaledErrorFunctionIsRightTo14Digits(double x, double expected) {
    assertThat(Elementary.erfcScaled(x)).isCloseTo(expected, within(1e-14 * expected));
  }

  @Test
  void logarithmAndExponentialOfSmallNumbersKeepTheirDigits() {
    for (double x : new double[] {1e-300, 1e-20, -1e-20, 1e-9, -1e-9, -.3, 2}) {
      assertThat(Elementary.expm1(Elementary.log1p(x))).isCloseTo(x, within(4 * EPS * Math.abs(x)));
    }
    assertThat(Elementary.log1p(1e-9)).isCloseTo(1e-9 - .5e-18, within(1e-24));
    assertThat(Elementary.expm1(1e-9)).isCloseTo(1e-9 + .5e-18, within(1e-24));
    assertThat(Elementary.log1p(-(1 - 0x1p-53))).isCloseTo(-53 * Math.log(2), within(1e-14));
  }

  /** The table of {@link Elementary#erfcScaled} is made from this series. */
  @ParameterizedTest
  @CsvSource({
    "0, 1",
    "1e-12, .99999999999887162083",
    ".1, .89645697996912663666",
    "1, .42758357615580700441",
    "3.7, .14743499753718507247",
    "20, .028174348741051319319",
    "1e8, 5.6418958354775625874e-9",
  })
  void seriesOfTheErrorFunctionIsRightTo14Digits(double x, double expected) {
    double t = 2 / (2 + x);
    assertThat(t * Elementary.Erfc.series(t)).isCloseTo(expected, within(1e-14 * expected));
  }

  @Test
  void tangentIsSineOverCosine() {
    for (double degrees = -89.5; degrees < 90; degrees += .5) {
      double expected = Elementary.sinDegrees(degrees) / Elementary.cosDegrees(degrees);
      assertThat(Elementary.tanDegrees(degrees))
          .isCloseTo(expected, within(1e-13 * Math.abs(expected)));
    }
    assertThat(Elementary.tanDegrees(45)).isCloseTo(1, within(2 * EPS));
  }

  @Test
  void logarithmUndoesTheExponential() {
    for (double x = -700; x < 700; x += 7.3) {
      assertThat(Elementary.log(Elementary.exp(x)))
          .isCloseTo(x, within(4 * EPS * (1 + Math.abs(x))));
    }
    assertThat(Elementary.log(1)).isZero();
    assertThat(Elementary.log(0)).isEqualTo(Double.NEGATIVE_INFINITY);
  }

  @Test
  void powersMultiplyAsTheirExponentsAdd() {
    assertThat(Elementary.pow(3, 4)).isEqualTo(81);
    assertThat(Elementary.pow(2, -3)).isEqualTo(.125);
    for (int i = 0; i < 1000; i++) {
      double base = random.nextDouble(.01, 10);
      double a = random.nextDouble(-3, 3);
      double b = random.nextDouble(-3, 3);
      double product = Elementary.pow(base, a) * Elementary.pow(base, b);
      assertThat(Elementary.pow(base, a + b)).isCloseTo(product, within(1e-14 * product));
    }
  }
}
