package io.github.lumbre.geometry;

import io.github.lumbre.math.Vec3;

/**
 * How the shading normal of a surface changes around a point, to first order. In world space.
 * Immutable.
 *
 * @param normal the shading normal at the point, of any length
 * @param alongX its product with a step along the surface is the step's first coordinate
 * @param changeX the change of {@code normal} per unit of the first coordinate
 * @param alongY its product with a step along the surface is the step's second coordinate
 * @param changeY the change of {@code normal} per unit of the second coordinate
 */
public record NormalGradient(
    Vec3 normal, Vec3 alongX, Vec3 changeX, Vec3 alongY, Vec3 changeY) {
  /** The normal of a flat surface, which does not change. */
  public static final NormalGradient FLAT =
      new NormalGradient(Vec3.Z, Vec3.ZERO, Vec3.ZERO, Vec3.ZERO, Vec3.ZERO);

  /** Returns the change of the unit normal along a step on the surface. */
  public Vec3 change(Vec3 step) {
    double length = normal.length();
    Vec3 unit = normal.times(1 / length);
    Vec3 change =
        changeX.times(alongX.dot(step) / length).plus(alongY.dot(step) / length, changeY);
    return change.plus(-change.dot(unit), unit);
  }
}
