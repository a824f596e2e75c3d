package io.github.lumbre.geometry;

import io.github.lumbre.math.Vec3;

/**
 * How the shading normal of a surface changes around a point, to first order. In world space.
 * Immutable.
 *
 * @param normal the shading normal at the point, of any length above 0
 * @param alongX the dot product with it is the first coordinate of a step along the surface
 * @param changeX the change of {@code normal} per unit of the first coordinate
 * @param alongY the dot product with it is the second coordinate of a step along the surface
 * @param changeY the change of {@code normal} per unit of the second coordinate
 */
public record NormalGradient(
    Vec3 normal, Vec3 alongX, Vec3 changeX, Vec3 alongY, Vec3 changeY) {
  /** The normal of a flat surface, which does not change. */
  public static final NormalGradient FLAT =
      new NormalGradient(Vec3.Z, Vec3.ZERO, Vec3.ZERO, Vec3.ZERO, Vec3.ZERO);

  /**
   * Returns the change of the unit normal along a step; it is perpendicular to the normal.
   *
   * @param step along the surface, in world units
   */
  public Vec3 change(Vec3 step) {
    double length = normal.length();
    Vec3 unit = normal.times(1 / length);
    Vec3 change =
        changeX.times(alongX.dot(step) / length).plus(alongY.dot(step) / length, changeY);
    return change.plus(-change.dot(unit), unit);
  }
}
