package io.github.lumbre.testing;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import java.util.random.RandomGenerator;

/** Random points and directions. */
public final class Draws {
  private Draws() {}

  /** Returns a point of the unit square. */
  public static Point2 inSquare(RandomGenerator random) {
    return new Point2(random.nextDouble(), random.nextDouble());
  }

  /** Returns a point whose coordinates are between minus and plus the size. */
  public static Vec3 inCube(RandomGenerator random, double size) {
    return new Vec3(
        random.nextDouble(-size, size),
        random.nextDouble(-size, size),
        random.nextDouble(-size, size));
  }

  /** Returns a unit vector, not quite evenly distributed. */
  public static Vec3 direction(RandomGenerator random) {
    return inCube(random, 1).normalized();
  }
}
