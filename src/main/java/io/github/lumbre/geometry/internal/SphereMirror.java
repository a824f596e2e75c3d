package io.github.lumbre.geometry.internal;

import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.Optional;

/**
 * The outside of a mirror that is a sphere, in world space. Between two points outside there is at
 * most one point of the sphere that reflects the one to the other: the problem of Alhazen (Glaeser
 * 1999, "Reflections on Spheres and Cylinders of Revolution"). Immutable.
 *
 * @param center in world space
 * @param radius in world units, &gt; 0
 */
public record SphereMirror(Vec3 center, double radius) {
  /** The largest relative difference of the half axes of a sphere. */
  private static final double ROUND = 1e-12;

  private static final int MOST_STEPS = 64;

  /** A change of the solution, at most 1, that ends the search. */
  private static final double CONVERGED = 0x1p-51;

  /** Returns a sphere as a mirror; empty if its transform makes it an ellipsoid. */
  public static Optional<SphereMirror> of(Sphere sphere) {
    Transform toWorld = sphere.toWorld();
    double x = toWorld.vector(Vec3.X).length();
    double y = toWorld.vector(Vec3.Y).length();
    double z = toWorld.vector(Vec3.Z).length();
    boolean isRound =
        !toWorld.isSkewed() && Math.abs(x - y) <= ROUND * x && Math.abs(x - z) <= ROUND * x;
    return isRound
        ? Optional.of(new SphereMirror(toWorld.point(Vec3.ZERO), sphere.radius() * x))
        : Optional.empty();
  }

  /**
   * Returns the outward unit normal of the sphere where it reflects light from one point to the
   * other; {@link Vec3#ZERO} if it does so nowhere, or if a point is inside.
   */
  public Vec3 normalBetween(Vec3 from, Vec3 to) {
    Vec3 a = from.minus(center).times(1 / radius);
    Vec3 b = to.minus(center).times(1 / radius);
    double p = a.length();
    double q = b.length();
    if (!(p > 1 && q > 1 && p < Double.POSITIVE_INFINITY && q < Double.POSITIVE_INFINITY)) {
      return Vec3.ZERO;
    }
    // The reflection lies in the plane of the center and both points, at an angle φ from the first
    // point, where γ is the angle between both.
    Vec3 axis = a.times(1 / p);
    double cos = axis.dot(b) / q;
    Vec3 across = b.times(1 / q).plus(-cos, axis);
    double sin = across.length();
    if (!(sin > 0)) {
      return cos > 0 ? axis : Vec3.ZERO;
    }
    double t = tangentOfHalf(p, q, cos, sin);
    if (!(t >= 0)) {
      return Vec3.ZERO;
    }
    double scale = 1 / (1 + t * t);
    return axis.times((1 - t * t) * scale).plus(2 * t * scale / sin, across).normalized();
  }

  /**
   * Returns tan(φ/2) where the angles of incidence and reflection are equal; NaN if no point of the
   * unit sphere sees both points.
   *
   * <p>The angle at which the first point is seen grows with φ, from 0 to 90° at cos φ = 1/p; that
   * of the second point falls. The equality of their tangents, p sin φ / (p cos φ − 1) and q sin(γ
   * − φ) / (q cos(γ − φ) − 1), multiplied by both denominators, is the zero that Newton's method
   * finds here, within bounds.
   *
   * @param p distance of the first point from the center of the unit sphere
   * @param q distance of the second point
   * @param cos cosine of the angle between both points, as seen from the center
   * @param sin its sine, &gt; 0
   */
  private static double tangentOfHalf(double p, double q, double cos, double sin) {
    double high = Math.sqrt((p - 1) / (p + 1));
    double horizon = Math.sqrt((q - 1) / (q + 1));
    double low = Math.max(0, (sin - horizon * (1 + cos)) / (1 + cos + horizon * sin));
    if (!(low < high)) {
      return Double.NaN;
    }
    double t = start(low, high, p, q, cos, sin);
    for (int step = 0; step < MOST_STEPS; step++) {
      double scale = 1 / (1 + t * t);
      double c = (1 - t * t) * scale;
      double s = 2 * t * scale;
      double sinRest = sin * c - cos * s;
      double cosRest = cos * c + sin * s;
      double sinDifference = s * cosRest - c * sinRest;
      double cosDifference = c * cosRest + s * sinRest;
      double value = p * q * sinDifference - p * s + q * sinRest;
      double slope = 2 * scale * (2 * p * q * cosDifference - p * c - q * cosRest);
      if (value > 0) {
        high = t;
      } else {
        low = t;
      }
      double next = t - value / slope;
      if (!(next > low && next < high)) {
        next = .5 * (low + high);
      }
      double change = Math.abs(next - t);
      t = next;
      if (change <= CONVERGED * t) {
        break;
      }
    }
    return t;
  }

  /** Returns the solution for small angles if it lies within the bounds, else their middle. */
  private static double start(double low, double high, double p, double q, double cos, double sin) {
    double share = q * (p - 1) / (q * (p - 1) + p * (q - 1));
    double t = share * sin / (1 + cos);
    return t > low && t < high ? t : .5 * (low + high);
  }

  /**
   * Returns the solid angle that a beam has at the first point, per solid angle that it has at the
   * center of the sphere, if it is reflected to a point of a surface.
   *
   * <p>A beam of the solid angle ω that a sphere reflects after a distance a has, after a further
   * distance b, the cross section ω (a + b + 2ab cos θ / r) (a + b + 2ab / (r cos θ)), by
   * Coddington's equations (Born and Wolf 1999, "Principles of Optics", sec. 4.6).
   *
   * @param from the first point
   * @param reflection the point of the sphere
   * @param to the point of a surface
   * @param surfaceNormal unit normal of that surface, of either sign
   * @return the ratio, &gt; 0; 0 or infinite or NaN where a beam only touches a surface
   */
  public double narrowing(Vec3 from, Vec3 reflection, Vec3 to, Vec3 surfaceNormal) {
    Vec3 incident = reflection.minus(from);
    Vec3 reflected = to.minus(reflection);
    Vec3 direct = to.minus(center);
    double a = incident.length();
    double b = reflected.length();
    double d = direct.length();
    double bend = 2 * a * b / radius;
    double cosine = -incident.dot(reflection.minus(center)) / (a * radius);
    double section = (a + b + bend * cosine) * (a + b + bend / cosine);
    double slant = Math.abs(surfaceNormal.dot(reflected)) / b;
    double slantFromCenter = Math.abs(surfaceNormal.dot(direct)) / d;
    return slant * d * d / (slantFromCenter * section);
  }
}
