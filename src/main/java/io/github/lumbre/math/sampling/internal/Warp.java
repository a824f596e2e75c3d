package io.github.lumbre.math.sampling.internal;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;

/** Area-preserving maps from the unit square to other domains, with their densities. */
public final class Warp {
  public static final double INV_FOUR_PI = 1 / (4 * Math.PI);
  private static final double QUARTER_PI = Math.PI / 4;

  private Warp() {}

  /**
   * Returns a uniform point of the unit disk. The map takes (0.5, 0.5) to the center, and
   * concentric squares to concentric circles.
   *
   * <p>Shirley &amp; Chiu 1997, "A Low Distortion Map Between Disk and Square".
   */
  public static Point2 concentricDisk(Point2 u) {
    long a = Double.doubleToRawLongBits(2 * u.x() - 1);
    long b = Double.doubleToRawLongBits(2 * u.y() - 1);
    // All bits are set in one half of the square. A branch here would be unpredictable.
    long wide = (b & Long.MAX_VALUE) - (a & Long.MAX_VALUE) >> 63;
    long swap = (a ^ b) & wide;
    double radius = Double.longBitsToDouble(b ^ swap);
    double phi = radius == 0 ? 0 : QUARTER_PI * (Double.longBitsToDouble(a ^ swap) / radius);
    double along = radius * Elementary.cosSmall(phi);
    double across = radius * Elementary.sinSmall(phi);
    long x = Double.doubleToRawLongBits(across);
    long y = Double.doubleToRawLongBits(along);
    swap = (x ^ y) & wide;
    return new Point2(Double.longBitsToDouble(x ^ swap), Double.longBitsToDouble(y ^ swap));
  }

  /** Returns a unit direction around +z with density cos θ / π (Malley's method). */
  public static Vec3 cosineHemisphere(Point2 u) {
    Point2 d = concentricDisk(u);
    return new Vec3(d.x(), d.y(), Elementary.safeSqrt(1 - d.x() * d.x() - d.y() * d.y()));
  }

  /** Returns the density of {@link #cosineHemisphere} per solid angle; 0 below the horizon. */
  public static double cosineHemispherePdf(double cosTheta) {
    return Math.max(0, cosTheta) * Elementary.INV_PI;
  }

  /** Returns a unit direction, uniform on the sphere. */
  public static Vec3 uniformSphere(Point2 u) {
    return direction(1 - 2 * u.x(), 2 * Math.sqrt(u.x() * (1 - u.x())), u.y());
  }

  /** Returns a unit vector, uniform on the hemisphere around +z. */
  public static Vec3 uniformHemisphere(Point2 u) {
    double z = u.x();
    return direction(z, Math.sqrt((1 - z) * (1 + z)), u.y());
  }

  /**
   * Returns a unit direction, uniform in the cone around +z.
   *
   * @param oneMinusCosMax 1 − cos of the cone's half angle, in [0,2]; this form keeps full
   *     precision for narrow cones
   */
  public static Vec3 uniformCone(Point2 u, double oneMinusCosMax) {
    double h = u.x() * oneMinusCosMax;
    return direction(1 - h, Elementary.safeSqrt(h * (2 - h)), u.y());
  }

  /** Returns the density of {@link #uniformCone} per solid angle, inside the cone. */
  public static double uniformConePdf(double oneMinusCosMax) {
    return 1 / (Elementary.TWO_PI * oneMinusCosMax);
  }

  /**
   * Returns the first two barycentric weights of a uniform point of a triangle.
   *
   * <p>Osada et al. 2002, "Shape Distributions", eq. 1.
   */
  public static Point2 uniformTriangle(Point2 u) {
    double root = Math.sqrt(u.x());
    return new Point2(1 - root, u.y() * root);
  }

  private static Vec3 direction(double cosTheta, double sinTheta, double turns) {
    return new Vec3(
        sinTheta * Elementary.cosTurns(turns), sinTheta * Elementary.sinTurns(turns), cosTheta);
  }
}
