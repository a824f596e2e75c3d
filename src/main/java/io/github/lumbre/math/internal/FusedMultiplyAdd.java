package io.github.lumbre.math.internal;

/**
 * The sum of a product and a number, rounded once, as {@link Math#fma} returns it, at a fair speed
 * on every processor.
 *
 * <p>Where the processor has no such instruction, or Java does not use it, {@link Math#fma}
 * computes with {@link java.math.BigDecimal}, which takes hundreds of times as long. There this
 * class adds exact products of doubles instead. Both have the same bits, so that the choice, which
 * is made once by their times, changes nothing else.
 */
public final class FusedMultiplyAdd {
  /** 2^27 + 1, which splits a number into two halves of 26 bits (Dekker 1971). */
  private static final double SPLIT = 0x1p27 + 1;

  /** Up to here, halves, products and sums are finite. */
  private static final double MAX_FACTOR = 0x1p990;

  private static final double MAX_TERM = 0x1p1000;

  /** From here on, the rounding error of a product is a double. */
  private static final double MIN_PRODUCT = 0x1p-900;

  private static final int TRIALS = 8;
  private static final int CALLS = 16;

  private static final boolean IS_FAST = isFaster();

  private FusedMultiplyAdd() {}

  /** Returns whether {@link Math#fma} is fast in this JVM. */
  public static boolean isFast() {
    return IS_FAST;
  }

  /** Returns ab + c, rounded once. */
  public static double of(double a, double b, double c) {
    return IS_FAST ? Math.fma(a, b, c) : ofExactProduct(a, b, c);
  }

  /**
   * Returns the same by additions and multiplications alone, unless numbers are so small or large
   * that those would not be exact. Source: Boldo and Melquiond 2008, "Emulation of a FMA and
   * Correctly Rounded Sums: Proved Algorithms Using Rounding to Odd", algorithm Fma.
   */
  static double ofExactProduct(double a, double b, double c) {
    double product = a * b;
    double size = Math.abs(product);
    if (!(size >= MIN_PRODUCT
        && size <= MAX_TERM
        && Math.abs(a) <= MAX_FACTOR
        && Math.abs(b) <= MAX_FACTOR
        && Math.abs(c) <= MAX_TERM)) {
      return Math.fma(a, b, c);
    }
    double productError = errorOfProduct(a, b, product);
    double low = c + productError;
    double lowError = errorOfSum(c, productError, low);
    double high = product + low;
    double highError = errorOfSum(product, low, high);
    return high + sumRoundedToOdd(lowError, highError);
  }

  /** Returns ab − product without error, by the halves of the factors (Dekker 1971). */
  private static double errorOfProduct(double a, double b, double product) {
    double scaledA = SPLIT * a;
    double highA = scaledA - (scaledA - a);
    double lowA = a - highA;
    double scaledB = SPLIT * b;
    double highB = scaledB - (scaledB - b);
    double lowB = b - highB;
    return lowA * lowB - (product - highA * highB - lowA * highB - highA * lowB);
  }

  /** Returns a + b − sum without error (Knuth 1998, "Seminumerical Algorithms", 4.2.2). */
  private static double errorOfSum(double a, double b, double sum) {
    double partOfB = sum - a;
    return (a - (sum - partOfB)) + (b - partOfB);
  }

  /**
   * Returns a + b, and where that is no double, the one of its two neighbors whose last bit is 1.
   * Rounded again, it never lies halfway by mistake.
   */
  private static double sumRoundedToOdd(double a, double b) {
    double sum = a + b;
    double error = errorOfSum(a, b, sum);
    if (error == 0) {
      return sum;
    }
    // One less, where the sum was rounded away from zero, cuts the rest off.
    long bits = Double.doubleToRawLongBits(sum);
    long away = (bits ^ Double.doubleToRawLongBits(error)) >> 63;
    return Double.longBitsToDouble(bits + away | 1);
  }

  /** Returns whether {@link Math#fma} is faster. The shortest of several times counts. */
  private static boolean isFaster() {
    long direct = Long.MAX_VALUE;
    long byProducts = Long.MAX_VALUE;
    double sum = 1;
    for (int trial = 0; trial < TRIALS; trial++) {
      long start = System.nanoTime();
      for (int i = 0; i < CALLS; i++) {
        sum = Math.fma(sum, .7, .3);
      }
      long middle = System.nanoTime();
      for (int i = 0; i < CALLS; i++) {
        sum = ofExactProduct(sum, .7, .3);
      }
      direct = Math.min(direct, middle - start);
      byProducts = Math.min(byProducts, System.nanoTime() - middle);
    }
    return direct < byProducts && sum > 0;
  }
}
