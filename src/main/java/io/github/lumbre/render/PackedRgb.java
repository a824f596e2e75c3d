package io.github.lumbre.render;

import io.github.lumbre.image.Rgb;

/**
 * A color packed in 64 bits: 18 bits for each component, and a shared exponent as in the RGBE
 * format (Ward 1991, "Real Pixels"). The error of each component is at most 2^-18 of the largest
 * component.
 */
final class PackedRgb {
  /** The value without a color, which is the initial value of arrays. */
  static final long NONE = 0;

  private static final int BITS = 18;
  private static final int MASK = (1 << BITS) - 1;
  private static final int BIAS = 512;

  private PackedRgb() {}

  /**
   * Returns the packed color, which is never {@link #NONE}.
   *
   * @param r red, 0 to 2^256
   * @param g green, 0 to 2^256
   * @param b blue, 0 to 2^256
   */
  static long of(double r, double g, double b) {
    double max = Math.max(r, Math.max(g, b));
    int exponent = max < 0x1p-256 ? -256 : Math.getExponent(max) + 1;
    if (Math.rint(Math.scalb(max, BITS - exponent)) > MASK) {
      exponent++;
    }
    return (long) (exponent + BIAS) << 3 * BITS
        | mantissa(r, exponent) << 2 * BITS
        | mantissa(g, exponent) << BITS
        | mantissa(b, exponent);
  }

  private static long mantissa(double v, int exponent) {
    return (long) Math.rint(Math.scalb(v, BITS - exponent));
  }

  /** Returns the color of a value from {@link #of}. */
  static Rgb unpacked(long packed) {
    int exponent = (int) (packed >>> 3 * BITS) - BIAS;
    double unit = Math.scalb(1.0, exponent - BITS);
    return new Rgb(
        unit * (packed >>> 2 * BITS & MASK),
        unit * (packed >>> BITS & MASK),
        unit * (packed & MASK));
  }
}
