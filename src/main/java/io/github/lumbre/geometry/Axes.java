package io.github.lumbre.geometry;

/**
 * Branch-free choices of an axis at the start of a traversal. Over rays of all directions, both
 * sides of such a branch are equally likely, and a misprediction costs more than a box test.
 */
final class Axes {
  private Axes() {}

  /** Returns 1 for negative numbers and -0, otherwise 0. */
  static int sign(double d) {
    return (int) (Double.doubleToRawLongBits(d) >>> 63);
  }

  /** Returns the axis, 0 to 2, along which a vector is longest; the last one of equals. */
  static int longest(double x, double y, double z) {
    long ax = size(x);
    long ay = size(y);
    long az = size(z);
    int order = isLess(az, ay) << 2 | isLess(ay, ax) << 1 | isLess(az, ax);
    // Two bits of the result for each order, from 7 to 0. Orders that contradict themselves do not
    // occur.
    return 0b00_10_01_01_00_10_10_10 >> 2 * order & 3;
  }

  /** Returns the largest absolute value of three numbers; NaN if any of them is NaN. */
  static double largest(double x, double y, double z) {
    return Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
  }

  /** Returns the sum of the absolute values of three numbers. */
  static double sum(double x, double y, double z) {
    return Math.abs(x) + Math.abs(y) + Math.abs(z);
  }

  /** Returns the next axis in cyclic order: y after x, z after y, x after z. */
  static int next(int axis) {
    return 0b00_10_01 >> 2 * axis & 3;
  }

  /** Returns the bits of a number without the sign; they sort as the absolute values do. */
  private static long size(double d) {
    return Double.doubleToRawLongBits(d) & Long.MAX_VALUE;
  }

  private static int isLess(long a, long b) {
    return (int) (a - b >>> 63);
  }
}
