package io.github.lumbre.integrator.guiding;

/** A test of whether two points of a scene see each other. */
@FunctionalInterface
public interface Sight {
  /**
   * Returns whether no surface lies between two points, in world space.
   *
   * @param x the first point, with y and z
   * @param dx the vector from it to the second point, with dy and dz; of any length above 0
   */
  boolean isClear(double x, double y, double z, double dx, double dy, double dz);
}
