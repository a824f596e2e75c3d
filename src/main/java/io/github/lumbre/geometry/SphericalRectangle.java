package io.github.lumbre.geometry;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.internal.Elementary;

/**
 * The directions from a point to a rectangle, with an area-preserving map from the unit square to
 * them.
 *
 * <p>Ureña, Fajardo &amp; King 2013, "An Area-Preserving Parametrization for Spherical Rectangles".
 * Unlike in the paper, the corner angles are not computed separately. They are kept as complex
 * numbers, and the argument of their product is the sum of the angles.
 */
final class SphericalRectangle {
  /**
   * The smallest usable solid angle, in steradians. Below it, rounding errors of 1e-16 are
   * significant or could turn 0 into 2π.
   */
  private static final double SMALLEST = 1e-6;

  private final double x0;
  private final double x1;
  private final double y0;
  private final double y1;
  private final double z;

  /** The z components of the normals to the great circles through the edges y0 and y1. */
  private final double b0;

  private final double b1;

  /** The cosine and sine of the sum of the two corner angles at x0. */
  private final double cosLeft;

  private final double sinLeft;
  private final double solidAngle;

  /**
   * Creates a rectangle in coordinates whose origin is the point.
   *
   * @param x0 the left edge
   * @param x1 the right edge, above x0
   * @param y0 the lower edge
   * @param y1 the upper edge, above y0
   * @param z the distance to the plane of the rectangle, at least 0
   */
  SphericalRectangle(double x0, double x1, double y0, double y1, double z) {
    this.x0 = x0;
    this.x1 = x1;
    this.y0 = y0;
    this.y1 = y1;
    this.z = z;
    double zz = z * z;
    double rx0 = 1 / Math.sqrt(x0 * x0 + zz);
    double rx1 = 1 / Math.sqrt(x1 * x1 + zz);
    double ry0 = 1 / Math.sqrt(y0 * y0 + zz);
    double ry1 = 1 / Math.sqrt(y1 * y1 + zz);
    b0 = -y0 * ry0;
    b1 = y1 * ry1;
    // The angle at a corner has the cosine ±xy / (|x, z| |y, z|) and the sine z |x, y, z| / (|x, z|
    // |y, z|).
    double cos00 = x0 * rx0 * b0;
    double cos01 = x0 * rx0 * b1;
    double cos10 = -x1 * rx1 * b0;
    double cos11 = -x1 * rx1 * b1;
    double sin00 = z * Math.sqrt(x0 * x0 + y0 * y0 + zz) * (rx0 * ry0);
    double sin01 = z * Math.sqrt(x0 * x0 + y1 * y1 + zz) * (rx0 * ry1);
    double sin10 = z * Math.sqrt(x1 * x1 + y0 * y0 + zz) * (rx1 * ry0);
    double sin11 = z * Math.sqrt(x1 * x1 + y1 * y1 + zz) * (rx1 * ry1);
    cosLeft = cos00 * cos01 - sin00 * sin01;
    sinLeft = sin00 * cos01 + cos00 * sin01;
    double cosRight = cos10 * cos11 - sin10 * sin11;
    double sinRight = sin10 * cos11 + cos10 * sin11;
    // The sum of the four angles is the solid angle plus 2π (Girard's theorem).
    double angle =
        Elementary.atan2(
            sinLeft * cosRight + cosLeft * sinRight, cosLeft * cosRight - sinLeft * sinRight);
    boolean isAbove = x0 < 0 && x1 > 0 && y0 < 0 && y1 > 0;
    solidAngle = angle < 0 && isAbove ? angle + Elementary.TWO_PI : angle;
  }

  /** Returns whether the solid angle is large enough to be accurate. */
  boolean isUsable() {
    return solidAngle >= SMALLEST;
  }

  /** Returns the solid angle in steradians, in [0, 2π]. */
  double solidAngle() {
    return solidAngle;
  }

  /** Returns x and y of the point of the rectangle to which a point of the unit square maps. */
  Point2 at(Point2 u) {
    // The part of the rectangle up to x has the fraction u.x of the solid angle.
    double turns = u.x() * solidAngle / Elementary.TWO_PI;
    double cosPart = Elementary.cosTurns(turns);
    double sinPart = Elementary.sinTurns(turns);
    double cos = cosPart * cosLeft + sinPart * sinLeft;
    double sin = sinPart * cosLeft - cosPart * sinLeft;
    double side = (cos * b0 - b1) * sin;
    double square = b0 * b0 + b1 * b1 - 2 * cos * b0 * b1 - sin * sin;
    double x = within(x0, x1, Math.copySign(z * Math.abs(sin), side), square);
    // Along y, equal steps of the sine of the latitude cover equal solid angles (Archimedes).
    double dd = x * x + z * z;
    double h0 = y0 / Math.sqrt(dd + y0 * y0);
    double h1 = y1 / Math.sqrt(dd + y1 * y1);
    double h = h0 + u.y() * (h1 - h0);
    return new Point2(x, within(y0, y1, h * Math.sqrt(dd), (1 - h) * (1 + h)));
  }

  /**
   * Returns a / √square, clamped to [low, high]. If rounding makes the square ≤ 0, returns the
   * bound on the side of a.
   */
  private static double within(double low, double high, double a, double square) {
    double ratio = square > 0 ? a / Math.sqrt(square) : Math.copySign(Double.MAX_VALUE, a);
    return Math.max(low, Math.min(ratio, high));
  }
}
