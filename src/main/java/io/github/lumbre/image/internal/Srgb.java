package io.github.lumbre.image.internal;

/**
 * The sRGB transfer curve (IEC 61966-2-1) and its inverse. All conversions between encoded values
 * and linear light use this class.
 *
 * <p>Powers use {@link StrictMath}, so that pictures are bit-identical on every machine.
 */
public final class Srgb {
  private static final double[] FROM_BYTE = new double[256];

  /** Upper limit of the linear values of each byte, with an error of some ulps. */
  private static final double[] LIMITS = new double[256];

  /** Lower bounds of the bytes of linear values from i / (length - 1) on. */
  private static final byte[] LEAST = new byte[1025];

  /** Values that differ from a limit by this share or more have the byte of their side. */
  private static final double UNCERTAINTY = 1e-12;

  static {
    for (int i = 0; i < FROM_BYTE.length; i++) {
      FROM_BYTE[i] = decode(i / 255.0);
      LIMITS[i] = decode((i + .5) / 255);
    }
    int least = 0;
    for (int i = 0; i < LEAST.length; i++) {
      while (LIMITS[least] * (LEAST.length - 1) < i) {
        least++;
      }
      LEAST[i] = (byte) Math.max(0, least - 1);
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
   * #fromByte}. It equals the byte of {@link #encode}, but is found without powers.
   */
  public static int toByte(double linear) {
    double v = clamp(linear);
    int encoded = LEAST[(int) (v * (LEAST.length - 1))] & 0xff;
    while (v > LIMITS[encoded]) {
      encoded++;
    }
    boolean isCertain =
        v < LIMITS[encoded] * (1 - UNCERTAINTY)
            && (encoded == 0 || v > LIMITS[encoded - 1] * (1 + UNCERTAINTY));
    return isCertain ? encoded : (int) Math.round(255 * encode(v));
  }

  /**
   * Returns one of the two encoded bytes around a linear value. In between, the curve is taken for a
   * line, which differs from it by at most .02 of a step.
   *
   * @param least the part of a step from which on the upper one is taken, in (0,1)
   */
  public static int toByte(double linear, double least) {
    double v = clamp(linear);
    int nearest = toByte(v);
    int lower = Math.min(v < FROM_BYTE[nearest] ? nearest - 1 : nearest, 254);
    double part = (v - FROM_BYTE[lower]) / (FROM_BYTE[lower + 1] - FROM_BYTE[lower]);
    return part < least ? lower : lower + 1;
  }

  /** Returns the value clamped to [0,1]; NaN gives 0. */
  public static double clamp(double v) {
    return v > 0 ? Math.min(v, 1) : 0;
  }
}
