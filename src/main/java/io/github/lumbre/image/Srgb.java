package io.github.lumbre.image;

/**
 * The sRGB transfer curve (IEC 61966-2-1) and its inverse. All conversions between encoded values
 * and linear light use this class.
 *
 * <p>Powers use {@link StrictMath}, so that pictures are bit-identical on every machine.
 */
public final class Srgb {
  private static final double[] FROM_BYTE = new double[256];

  static {
    for (int i = 0; i < FROM_BYTE.length; i++) {
      FROM_BYTE[i] = decode(i / 255.0);
    }
  }

  private Srgb() {}

  /** Returns the linear value in [0,1] of an encoded value in [0,1]. */
  public static double decode(double encoded) {
    return encoded <= .04045 ? encoded / 12.92 : StrictMath.pow((encoded + .055) / 1.055, 2.4);
  }

  /**
   * Returns the encoded value in [0,1] of a linear value, which is clamped to [0,1]; NaN gives 0.
   */
  public static double encode(double linear) {
    double v = clamp(linear);
    if (v <= .0031308) {
      return 12.92 * v;
    }
    // In doubles, the formula gives 1 minus an ulp at v = 1.
    return v == 1 ? 1 : 1.055 * StrictMath.pow(v, 1 / 2.4) - .055;
  }

  /**
   * Returns the linear value of an encoded byte, from a table.
   *
   * @param encoded 0 to 255
   */
  public static double fromByte(int encoded) {
    return FROM_BYTE[encoded];
  }

  /**
   * Returns the encoded byte, 0 to 255, nearest to a linear value; the inverse of {@link
   * #fromByte}.
   */
  public static int toByte(double linear) {
    return (int) Math.round(255 * encode(linear));
  }

  /** Returns the value clamped to [0,1]; NaN gives 0. */
  static double clamp(double v) {
    return v > 0 ? Math.min(v, 1) : 0;
  }
}
