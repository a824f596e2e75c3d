package io.github.lumbre.math;

/**
 * Elementary functions that give the same bits on every virtual machine and processor.
 *
 * <p>{@link Math#sin} and its kin may differ by an ulp between machines, and between interpreted
 * and compiled code; whatever stands between a sample and the film uses this class instead. Sine
 * and cosine are own kernels made of + − × alone; the rest is {@link StrictMath}.
 */
public final class Elementary {
  public static final double TWO_PI = 2 * Math.PI;
  public static final double INV_PI = 1 / Math.PI;
  private static final double RADIANS_PER_DEGREE = Math.PI / 180;

  private Elementary() {}

  /**
   * Returns the sine of an angle of at most a quarter of π in size, by its Taylor series to the
   * 17th power (truncation below 1e-19).
   */
  public static double sinSmall(double x) {
    double s = x * x;
    double p = 1.0 / 355687428096000.0;
    p = p * s - 1.0 / 1307674368000.0;
    p = p * s + 1.0 / 6227020800.0;
    p = p * s - 1.0 / 39916800.0;
    p = p * s + 1.0 / 362880.0;
    p = p * s - 1.0 / 5040.0;
    p = p * s + 1.0 / 120.0;
    p = p * s - 1.0 / 6.0;
    return x + x * (s * p);
  }

  /**
   * Returns the cosine of an angle of at most a quarter of π in size (series to the 18th power).
   */
  public static double cosSmall(double x) {
    double s = x * x;
    double p = -1.0 / 6402373705728000.0;
    p = p * s + 1.0 / 20922789888000.0;
    p = p * s - 1.0 / 87178291200.0;
    p = p * s + 1.0 / 479001600.0;
    p = p * s - 1.0 / 3628800.0;
    p = p * s + 1.0 / 40320.0;
    p = p * s - 1.0 / 720.0;
    p = p * s + 1.0 / 24.0;
    p = p * s - .5;
    return 1 + s * p;
  }

  /**
   * Returns the sine of a number of full turns: exactly 0, ±1 at multiples of a quarter turn.
   *
   * @param turns any finite number; 1 is 360°
   */
  public static double sinTurns(double turns) {
    double part = turns - Math.rint(turns);
    double quarters = Math.rint(4 * part);
    return sin((int) quarters, (part - .25 * quarters) * TWO_PI);
  }

  /** Returns the cosine of a number of full turns; see {@link #sinTurns}. */
  public static double cosTurns(double turns) {
    double part = turns - Math.rint(turns);
    double quarters = Math.rint(4 * part);
    return sin((int) quarters + 1, (part - .25 * quarters) * TWO_PI);
  }

  /** Returns the sine of an angle in degrees: exact at multiples of 90. */
  public static double sinDegrees(double degrees) {
    double part = Math.IEEEremainder(degrees, 360);
    double quarters = Math.rint(part / 90);
    return sin((int) quarters, (part - 90 * quarters) * RADIANS_PER_DEGREE);
  }

  /** Returns the cosine of an angle in degrees: exact at multiples of 90. */
  public static double cosDegrees(double degrees) {
    double part = Math.IEEEremainder(degrees, 360);
    double quarters = Math.rint(part / 90);
    return sin((int) quarters + 1, (part - 90 * quarters) * RADIANS_PER_DEGREE);
  }

  /** Returns the sine of some quarter turns and a rest of at most an eighth of a turn. */
  private static double sin(int quarters, double rest) {
    return switch (quarters & 3) {
      case 0 -> sinSmall(rest);
      case 1 -> cosSmall(rest);
      case 2 -> -sinSmall(rest);
      default -> -cosSmall(rest);
    };
  }

  /** Returns the tangent of an angle in degrees. */
  public static double tanDegrees(double degrees) {
    return StrictMath.tan(StrictMath.toRadians(degrees));
  }

  /** Returns the angle of the point (x, y) in [-π, π]. */
  public static double atan2(double y, double x) {
    return StrictMath.atan2(y, x);
  }

  /** Returns the arc sine in [-π/2, π/2]; arguments beyond ±1 by rounding are taken as ±1. */
  public static double asin(double x) {
    return StrictMath.asin(Math.max(-1, Math.min(1, x)));
  }

  public static double log(double x) {
    return StrictMath.log(x);
  }

  public static double exp(double x) {
    return StrictMath.exp(x);
  }

  public static double pow(double base, double exponent) {
    return StrictMath.pow(base, exponent);
  }

  /** Returns the square root of x, or 0 where rounding made x negative. */
  public static double safeSqrt(double x) {
    return Math.sqrt(Math.max(0, x));
  }
}
