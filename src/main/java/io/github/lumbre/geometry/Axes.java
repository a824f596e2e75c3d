package io.github.lumbre.geometry;

/**
 * Choices of an axis at the beginning of a search, made by arithmetic: for rays of all directions a
 * branch goes either way as often, and mispredicting it costs more than testing a box.
 */
final class Axes {
  private Axes() {}

  /** Returns 1 for negative numbers and -0, otherwise 0. */
  static int sign(double d) {
    return (int) (Double.doubleToRawLongBits(d) >>> 63);
  }

  /** Returns the axis along which a vector is longest; of equals, the last. */
  static int longest(double x, double y, double z) {
    long ax = size(x);
    long ay = size(y);
    long az = size(z);
    int notX = 1 - isLess(ay, ax) | 1 - isLess(az, ax);
    int z2 = 2 - isLess(az, ay);
    return notX * (isLess(ay, ax) * 2 + (1 - isLess(ay, ax)) * z2);
  }

  /** Returns the largest of three numbers' sizes; NaN if one is NaN. */
  static double largest(double x, double y, double z) {
    return Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
  }

  /** Returns the sum of three numbers' sizes. */
  static double sum(double x, double y, double z) {
    return Math.abs(x) + Math.abs(y) + Math.abs(z);
  }

  /** Returns the axis after another: y after x, z after y, x after z. */
  static int next(int axis) {
    return 0b00_10_01 >> 2 * axis & 3;
  }

  /** Returns a number's bits without the sign, which are in the order of sizes. */
  private static long size(double d) {
    return Double.doubleToRawLongBits(d) & Long.MAX_VALUE;
  }

  private static int isLess(long a, long b) {
    return (int) (a - b >>> 63);
  }
}
