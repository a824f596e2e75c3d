package io.github.lumbre.light.internal;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;

/** The directions of lights that have an axis. */
public final class Directions {
  /** Vectors whose squared length is this close to 1 count as unit vectors. */
  private static final double UNIT = 1e-14;

  private Directions() {}

  /**
   * Returns a direction with length 1.
   *
   * @throws IllegalArgumentException if it is zero or not finite
   */
  public static Vec3 unit(String name, Vec3 direction) {
    if (!(direction.maxAbs() > 0) || !direction.isFinite()) {
      throw new IllegalArgumentException(
          name + ": expected a finite vector other than 0, found " + direction);
    }
    Vec3 unit = direction.normalized();
    // 0 in place of -0, as transforms have it.
    return new Vec3(unit.x() + 0., unit.y() + 0., unit.z() + 0.);
  }

  /** Returns a map of the local origin to a position and of local +z to a unit direction. */
  public static Transform pointing(Vec3 position, Vec3 direction) {
    return Transform.ofFrame(Frame.around(direction), position);
  }

  /** Returns the unit world direction of local +z; one that is a unit vector stays as it is. */
  public static Vec3 axis(Transform toWorld) {
    Vec3 z = toWorld.vector(Vec3.Z);
    return Math.abs(z.lengthSquared() - 1) <= UNIT ? z : z.normalized();
  }
}
