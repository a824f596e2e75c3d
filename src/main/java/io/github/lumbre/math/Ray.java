package io.github.lumbre.math;

/**
 * A ray: the points {@code origin + t·direction} for 0 &lt; t &lt; tMax.
 *
 * @param origin start of the ray, not part of it
 * @param direction not zero; of unit length unless the ray leads to a given point, which then is at
 *     t = 1
 * @param tMax end of the ray, not part of it; may be infinite
 */
public record Ray(Vec3 origin, Vec3 direction, double tMax) {
  /** Creates a ray of infinite length. */
  public Ray(Vec3 origin, Vec3 direction) {
    this(origin, direction, Double.POSITIVE_INFINITY);
  }

  /** Returns the point origin + t · direction. */
  public Vec3 at(double t) {
    return origin.plus(t, direction);
  }
}
