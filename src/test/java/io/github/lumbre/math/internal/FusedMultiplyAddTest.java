package io.github.lumbre.math.internal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Compares sums of exact products with {@link Math#fma}, bit by bit. */
class FusedMultiplyAddTest {
  private static final double[] SPECIAL = {
    0.0,
    -0.0,
    1,
    -1,
    1 + 0x1p-52,
    1 - 0x1p-53,
    0x1.fffffffffffffp0,
    0x1p26 + 1,
    0x1p27 + 1,
    0x1.0000001p0,
    3,
    -1.0 / 3,
    Double.MIN_VALUE,
    -Double.MIN_VALUE,
    3 * Double.MIN_VALUE,
    Double.MIN_NORMAL,
    Double.MIN_NORMAL - Double.MIN_VALUE,
    0x1.5p-1000,
    0x1p-900,
    0x1.fffffffffffffp-451,
    0x1p-450,
    0x1.fffffffffffffp499,
    0x1p500,
    0x1p990,
    0x1.0000000000001p990,
    0x1p1000,
    0x1.0000000000001p1000,
    0x1.8p1023,
    Double.MAX_VALUE,
    -Double.MAX_VALUE,
    Double.POSITIVE_INFINITY,
    Double.NEGATIVE_INFINITY,
    Double.NaN,
  };

  private final SplittableRandom random = new SplittableRandom(18);

  private static void assertSame(double a, double b, double c) {
    long expected = Double.doubleToLongBits(Math.fma(a, b, c));
    long actual = Double.doubleToLongBits(FusedMultiplyAdd.ofExactProduct(a, b, c));
    if (actual != expected) {
      assertThat(Double.longBitsToDouble(actual))
          .as("%a * %a + %a", a, b, c)
          .isEqualTo(Double.longBitsToDouble(expected));
      assertThat(actual).as("sign of zero of %a * %a + %a", a, b, c).isEqualTo(expected);
    }
    assertThat(Double.doubleToLongBits(FusedMultiplyAdd.of(a, b, c))).isEqualTo(expected);
  }

  @Test
  void zerosInfinitiesAndTheEndsOfTheRangesHaveTheSameBits() {
    for (double a : SPECIAL) {
      for (double b : SPECIAL) {
        for (double c : SPECIAL) {
          assertSame(a, b, c);
        }
        assertSame(a, b, -a * b);
        assertSame(a, b, Math.nextUp(-a * b));
      }
    }
  }

  /** Subnormal and huge numbers too, and NaN. */
  @Test
  void anyBitsOfDoublesHaveTheSameBits() {
    for (int i = 0; i < 1_000_000; i++) {
      assertSame(
          Double.longBitsToDouble(random.nextLong()),
          Double.longBitsToDouble(random.nextLong()),
          Double.longBitsToDouble(random.nextLong()));
    }
  }

  /** A term that cancels the product, or touches its last bits only. */
  @Test
  void termsOfTheSizeOfTheProductOrItsErrorHaveTheSameBits() {
    for (int i = 0; i < 3_000_000; i++) {
      double a = number(random.nextInt(-460, 500));
      double b = number(random.nextInt(-460, 500));
      int exponent = Math.getExponent(a * b);
      assertSame(a, b, number(exponent - random.nextInt(-110, 170)));
      assertSame(a, b, -a * b + random.nextInt(-3, 4) * Math.ulp(a * b) / 4);
    }
  }

  /** Sums that lie halfway between two doubles, or beside the middle by the last bit of all. */
  @Test
  void sumsNearTheMiddleOfTwoDoublesHaveTheSameBits() {
    for (int i = 0; i < 1_000_000; i++) {
      int bits = random.nextInt(1, 53);
      double a = 1 + random.nextInt(-2, 3) * Math.scalb(1.0, -bits);
      double b = 1 + random.nextInt(-2, 3) * Math.scalb(1.0, bits - 54);
      double c = random.nextInt(-4, 5) * Math.scalb(1.0, random.nextInt(-110, 60));
      assertSame(a, b, c);
      assertSame(-a, b, c);
    }
  }

  /** Returns a random number of an exponent, often with few bits set. */
  private double number(int exponent) {
    long fraction = random.nextLong() >>> 12;
    if (random.nextInt(4) == 0) {
      fraction &= -1L << random.nextInt(52);
    }
    double value = Double.longBitsToDouble(1023L << 52 | fraction);
    return Math.scalb(random.nextBoolean() ? value : -value, exponent);
  }
}
