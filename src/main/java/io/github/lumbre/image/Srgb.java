package io.github.lumbre.image;

/**
 * The transfer curve of sRGB (IEC 61966-2-1) and its inverse: the only place where encoded values
 * become linear light or the reverse.
 *
 * <p>Powers are {@link StrictMath}'s, so that pictures have the same bits on every machine.
 */
public final class Srgb {
  private static final double[] FROM_BYTE = new double[256];

  static {
    for (int i = 0; i < FROM_BYTE.length; i++) {
      FROM_BYTE[i] = decode(i / 255.0);
    }
  }

  private Srgb() {}

  /** Returns the linear light in [0,1] of an encoded value in [0,1]. */
  public static double decode(double encoded) {
    return encoded <= .04045 ? encoded / 12.92 : StrictMath.pow((encoded + .055) / 1.055, 2.4);
  }

  /** Returns the encoded value in [0,1] of linear light, which is clamped to [0,1]; of NaN, 0. */
  public static double encode(double linear) {
    double v = clamp(linear);
    if (v <= .0031308) {
      return 12.92 * v;
    }
    // At 1 the formula in doubles falls short of 1 by an ulp.
    return v == 1 ? 1 : 1.055 * StrictMath.pow(v, 1 / 2.4) - .055;
  }

  /**
   * Returns the linear light of an encoded byte, from a table.
   *
   * @param encoded 0 to 255
   */
  public static double fromByte(int encoded) {
    return FROM_BYTE[encoded];
  }

  /** Returns the encoded byte, 0 to 255, nearest to linear light; undoes {@link #fromByte}. */
  public static int toByte(double linear) {
    return (int) Math.round(255 * encode(linear));
  }

  /** Returns the value limited to [0,1]; of NaN, 0. */
  static double clamp(double v) {
    return v > 0 ? Math.min(v, 1) : 0;
  }
}
