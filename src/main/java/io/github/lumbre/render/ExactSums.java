package io.github.lumbre.render;

/**
 * Sums of 128 bits. Each value is rounded once to a multiple of 2^-64, so that sums are
 * bit-identical for any order and grouping of the values. Mutable; different threads may change
 * different sums.
 */
final class ExactSums {
  /** The whole parts and the fractions (unsigned, in units of 2^-64) of the sums. */
  private final long[] whole;

  private final long[] fraction;

  /** Creates sums of nothing. */
  ExactSums(int size) {
    whole = new long[size];
    fraction = new long[size];
  }

  int size() {
    return whole.length;
  }

  void add(int i, double value) {
    long units = (long) value;
    // The fraction times 2^64; only fractions below 2^-12 are rounded, so the result is below 2^64.
    double rest = Math.rint((value - units) * 0x1p64);
    add(i, units, bits(rest));
  }

  /** Adds a value of any sign to a sum. */
  void addSigned(int i, double value) {
    double floor = Math.floor(value);
    // The fraction times 2^64; rounding can make it 2^64.
    double rest = Math.rint((value - floor) * 0x1p64);
    if (rest == 0x1p64) {
      add(i, (long) floor + 1, 0);
    } else {
      add(i, (long) floor, bits(rest));
    }
  }

  void add(int i, ExactSums other, int from) {
    add(i, other.whole[from], other.fraction[from]);
  }

  private void add(int i, long units, long bits) {
    long sum = fraction[i] + bits;
    whole[i] += units + carry(fraction[i], bits, sum);
    fraction[i] = sum;
  }

  /** Returns a number from 0 to below 2^64 as the bits of an unsigned integer. */
  private static long bits(double number) {
    return number < 0x1p63 ? (long) number : (long) (number - 0x1p63) | Long.MIN_VALUE;
  }

  /**
   * Returns the carry of the sum of two unsigned numbers, 0 or 1 (Warren 2012, sec. 2-16). Without
   * a branch: its first carry, after a while, would discard the code compiled until then.
   */
  static long carry(long a, long b, long sum) {
    return (a & b | (a | b) & ~sum) >>> Long.SIZE - 1;
  }

  /** Returns a sum, rounded. */
  double get(int i) {
    double low = (fraction[i] >>> 1) * 0x1p-63 + (fraction[i] & 1) * 0x1p-64;
    return whole[i] + low;
  }

  /** Returns the whole part of a sum, rounded down. */
  long whole(int i) {
    return whole[i];
  }

  /** Returns the fraction of a sum, unsigned, in units of 2^-64. */
  long fraction(int i) {
    return fraction[i];
  }

  /** Replaces a sum. */
  void set(int i, long newWhole, long newFraction) {
    whole[i] = newWhole;
    fraction[i] = newFraction;
  }

  /** Copies all sums of the same number of others. */
  void set(ExactSums other) {
    System.arraycopy(other.whole, 0, whole, 0, whole.length);
    System.arraycopy(other.fraction, 0, fraction, 0, fraction.length);
  }
}
