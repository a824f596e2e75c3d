package io.github.lumbre.math.internal;

/**
 * Elementary functions whose results are bit-identical on every JVM and processor.
 *
 * <p>{@link Math#sin} and similar methods may differ by an ulp between machines, and between
 * interpreted and compiled code. All code that computes samples uses this class instead. Functions
 * for inner loops use only + − × ÷ and {@link FusedMultiplyAdd}; the others call {@link
 * StrictMath}.
 */
public final class Elementary {
  public static final double TWO_PI = 2 * Math.PI;
  public static final double INV_PI = 1 / Math.PI;
  private static final double RADIANS_PER_DEGREE = Math.PI / 180;

  private static final int LOG_STEPS = 5;
  private static final int STEPS = 1 << LOG_STEPS;
  private static final double STEPS_PER_UNIT = STEPS / StrictMath.log(2);

  /** ln 2 / 32 as the sum of two parts. The first part ends in 20 zero bits. */
  private static final double STEP_HIGH = 0x1.62e42feep-1 / STEPS;

  private static final double STEP_LOW = 0x1.a39ef35793c76p-33 / STEPS;

  /** 2^(k/32) for k from 0 to 31. */
  private static final double[] POWERS = new double[STEPS];

  static {
    for (int k = 0; k < STEPS; k++) {
      POWERS[k] = StrictMath.pow(2, (double) k / STEPS);
    }
  }

  private Elementary() {}

  /**
   * Returns the sine of an angle in radians, in [-π/4, π/4], by its Taylor series up to the 15th
   * power (truncation error below 5e-17).
   */
  public static double sinSmall(double x) {
    double s = x * x;
    double p = FusedMultiplyAdd.of(-1.0 / 1307674368000.0, s, 1.0 / 6227020800.0);
    p = FusedMultiplyAdd.of(p, s, -1.0 / 39916800.0);
    p = FusedMultiplyAdd.of(p, s, 1.0 / 362880.0);
    p = FusedMultiplyAdd.of(p, s, -1.0 / 5040.0);
    p = FusedMultiplyAdd.of(p, s, 1.0 / 120.0);
    p = FusedMultiplyAdd.of(p, s, -1.0 / 6.0);
    return FusedMultiplyAdd.of(x, s * p, x);
  }

  /**
   * Returns the cosine of an angle in radians, in [-π/4, π/4], by its Taylor series up to the 16th
   * power (truncation error below 3e-18).
   */
  public static double cosSmall(double x) {
    double s = x * x;
    double p = FusedMultiplyAdd.of(1.0 / 20922789888000.0, s, -1.0 / 87178291200.0);
    p = FusedMultiplyAdd.of(p, s, 1.0 / 479001600.0);
    p = FusedMultiplyAdd.of(p, s, -1.0 / 3628800.0);
    p = FusedMultiplyAdd.of(p, s, 1.0 / 40320.0);
    p = FusedMultiplyAdd.of(p, s, -1.0 / 720.0);
    p = FusedMultiplyAdd.of(p, s, 1.0 / 24.0);
    p = FusedMultiplyAdd.of(p, s, -.5);
    return FusedMultiplyAdd.of(p, s, 1);
  }

  /**
   * Returns the sine of an angle in full turns; exactly 0 or ±1 at multiples of a quarter turn.
   *
   * @param turns any finite number; 1 is 360°
   */
  public static double sinTurns(double turns) {
    double part = turns - Math.rint(turns);
    double quarters = Math.rint(4 * part);
    return sin((int) quarters, (part - .25 * quarters) * TWO_PI);
  }

  /**
   * Returns the cosine of an angle in full turns; exactly 0 or ±1 at multiples of a quarter turn.
   *
   * @param turns any finite number; 1 is 360°
   */
  public static double cosTurns(double turns) {
    double part = turns - Math.rint(turns);
    double quarters = Math.rint(4 * part);
    return sin((int) quarters + 1, (part - .25 * quarters) * TWO_PI);
  }

  /** Returns the sine of an angle in degrees; exact at multiples of 90. */
  public static double sinDegrees(double degrees) {
    double part = Math.IEEEremainder(degrees, 360);
    double quarters = Math.rint(part / 90);
    return sin((int) quarters, (part - 90 * quarters) * RADIANS_PER_DEGREE);
  }

  /** Returns the cosine of an angle in degrees; exact at multiples of 90. */
  public static double cosDegrees(double degrees) {
    double part = Math.IEEEremainder(degrees, 360);
    double quarters = Math.rint(part / 90);
    return sin((int) quarters + 1, (part - 90 * quarters) * RADIANS_PER_DEGREE);
  }

  /**
   * Returns the sine of a number of quarter turns plus a remainder.
   *
   * @param rest remainder in radians, at most an eighth of a turn in size
   */
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

  /**
   * Returns the polar angle of the point (x, y) in radians, in [-π, π], with an error of at most 4
   * ulp. The signs of zeros matter as in {@link Math#atan2}.
   *
   * @param y finite
   * @param x finite
   */
  public static double atan2(double y, double x) {
    double ax = Math.abs(x);
    double ay = Math.abs(y);
    double larger = Math.max(ax, ay);
    double ratio = larger > 0 ? Math.min(ax, ay) / larger : 0;
    double angle = ratio * Atan.OVER_T.at(ratio);
    if (ay > ax) {
      angle = .5 * Math.PI - angle;
    }
    if (Math.copySign(1, x) < 0) {
      angle = Math.PI - angle;
    }
    return Math.copySign(angle, y);
  }

  /**
   * Returns the arcsine in radians, in [-π/2, π/2]. Arguments that rounding put beyond ±1 are taken
   * as ±1.
   */
  public static double asin(double x) {
    return atan2(x, safeSqrt((1 - x) * (1 + x)));
  }

  public static double log(double x) {
    return StrictMath.log(x);
  }

  /**
   * Returns e to the power x, with an error of at most 2 ulp (Tang 1989). x is split into a
   * multiple of ln 2 / 32 and a remainder. The power of the multiple comes from a table and the
   * exponent bits; the power of the remainder comes from six terms of the series.
   */
  public static double exp(double x) {
    if (!(Math.abs(x) <= 745.2)) {
      return x > 0 ? Double.POSITIVE_INFINITY : x < 0 ? 0 : x;
    }
    int k = (int) Math.rint(x * STEPS_PER_UNIT);
    // The product of k and the high part is exact.
    double r = FusedMultiplyAdd.of(-k, STEP_LOW, FusedMultiplyAdd.of(-k, STEP_HIGH, x));
    double series = FusedMultiplyAdd.of(r, 1.0 / 720, 1.0 / 120);
    series = FusedMultiplyAdd.of(r, series, 1.0 / 24);
    series = FusedMultiplyAdd.of(r, series, 1.0 / 6);
    series = FusedMultiplyAdd.of(r * r, FusedMultiplyAdd.of(r, series, .5), r);
    double power = POWERS[k & STEPS - 1];
    double value = FusedMultiplyAdd.of(power, series, power);
    int exponent = k >> LOG_STEPS;
    return Math.abs(exponent) < Double.MAX_EXPONENT
        ? value * Double.longBitsToDouble((long) (exponent + Double.MAX_EXPONENT) << 52)
        : Math.scalb(value, exponent);
  }

  /** Returns exp(x) − 1, with full relative precision near 0. */
  public static double expm1(double x) {
    return StrictMath.expm1(x);
  }

  /** Returns ln(1 + x), with full relative precision near 0. */
  public static double log1p(double x) {
    return StrictMath.log1p(x);
  }

  /** Returns exp(x²) · erfc(x), the scaled complementary error function, for x ≥ 0. */
  public static double erfcScaled(double x) {
    double t = 2 / (2 + x);
    return t * Erfc.OVER_T.at(t);
  }

  public static double pow(double base, double exponent) {
    return StrictMath.pow(base, exponent);
  }

  /** Returns the square root of x, or 0 where rounding made x negative. */
  public static double safeSqrt(double x) {
    return Math.sqrt(Math.max(0, x));
  }

  /** The complementary error function; a class, so that programs without it make no table. */
  static final class Erfc {
    /**
     * Chebyshev coefficients in 2t − 1 of ln(erfc(x) exp(x²) / t), t = 2 / (2 + x), computed with
     * 40 digits. This number of coefficients leaves a relative error of 2e-15.
     */
    private static final double[] COEFFICIENTS = {
      -1.30265371978170943, 0.64196979235649026, 0.0194764732041858363,
      -0.00956151478680863164, -0.000946595344482036866, 0.000366839497852761452,
      0.0000425233248069077716, -0.0000202785781125342432, -1.62429000464702551e-6,
      1.3036558355805232e-6, 1.56264417220661432e-8, -8.52380959149265425e-8,
      6.52905443909885149e-9, 5.05934349555146895e-9, -9.91364156493033091e-10,
      -2.27365122293183581e-10, 9.64679110201552645e-11, 2.39403808303911763e-12,
      -6.88602752649755563e-12, 8.94487927309074143e-13, 3.13092139934294907e-13,
      -1.12708223613672298e-13, 3.81090525519374139e-16, 7.10609761360811203e-15,
    };

    /** erfc(x) exp(x²) / t as a function of t = 2 / (2 + x). */
    private static final PiecewisePolynomial OVER_T = new PiecewisePolynomial(Erfc::series);

    private Erfc() {}

    /** Returns erfc(x) exp(x²) / t for t = 2 / (2 + x) in (0,1], by its Chebyshev series. */
    static double series(double t) {
      double y = 4 * t - 2;
      double b = 0;
      double next = 0;
      // Clenshaw's recurrence.
      for (int i = COEFFICIENTS.length - 1; i > 0; i--) {
        double last = b;
        b = y * b - next + COEFFICIENTS[i];
        next = last;
      }
      return exp(.5 * (y * b + COEFFICIENTS[0]) - next);
    }
  }

  /** The arc tangent; a class for the same reason. */
  private static final class Atan {
    /** atan(t) / t. */
    private static final PiecewisePolynomial OVER_T =
        new PiecewisePolynomial(t -> StrictMath.atan(t) / t);

    private Atan() {}
  }
}
