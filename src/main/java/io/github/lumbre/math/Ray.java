package io.github.lumbre.math;

/**
 * The points {@code origin + t·direction} for 0 &lt; t &lt; tMax.
 *
 * @param origin excluded from the ray
 * @param direction not zero; of unit length unless the ray was built towards a point, where t = 1
 *     is that point
 * @param tMax excluded from the ray; may be infinite
 */
public record Ray(Vec3 origin, Vec3 direction, double tMax) {
  /** Returns a ray without an end. */
  public Ray(Vec3 origin, Vec3 direction) {
    this(origin, direction, Double.POSITIVE_INFINITY);
  }

  public Vec3 at(double t) {
    return origin.plus(t, direction);
  }
}
