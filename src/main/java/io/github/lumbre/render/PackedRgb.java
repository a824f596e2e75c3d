package io.github.lumbre.render;

import io.github.lumbre.image.Rgb;

/**
 * A colour in 64 bits: 18 bits for each component and an exponent that they share, like the nine
 * bits of the RGBE formats (Ward 1991, "Real Pixels"). The largest component is kept to a relative
 * 2^-18, the others to as much of the largest.
 */
final class PackedRgb {
  /** No colour: what an array holds at first. */
  static final long NONE = 0;

  private static final int BITS = 18;
  private static final int MASK = (1 << BITS) - 1;
  private static final int BIAS = 512;

  private PackedRgb() {}

  /**
   * Returns the packed colour, which is never {@link #NONE}.
   *
   * @param r 0 to 2^256, like the others
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

  /** Returns the colour of what {@link #of} returned. */
  static Rgb unpacked(long packed) {
    int exponent = (int) (packed >>> 3 * BITS) - BIAS;
    double unit = Math.scalb(1.0, exponent - BITS);
    return new Rgb(
        unit * (packed >>> 2 * BITS & MASK),
        unit * (packed >>> BITS & MASK),
        unit * (packed & MASK));
  }
}
