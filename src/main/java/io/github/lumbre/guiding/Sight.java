package io.github.lumbre.guiding;

/** Tells whether points of a scene see each other. */
@FunctionalInterface
public interface Sight {
  /**
   * Returns whether nothing lies between two points, in world space.
   *
   * @param x first point, as are y and z
   * @param dx the way to the second point, as are dy and dz
   */
  boolean isClear(double x, double y, double z, double dx, double dy, double dz);
}
