package io.github.lumbre.geometry;

/**
 * The space of a hierarchy's floats: translated, and scaled by a power of two, so that all boxes
 * lie in [-1, 1]³. In it, float errors have an absolute bound that does not depend on the position
 * and size of the scene.
 */
final class UnitSpace {
  /**
   * Origins whose coordinates are at most this far from the center are inside, or barely outside.
   */
  static final double INSIDE = 1 + 0x1p-4;

  /** Origins whose coordinates are at most this far from the center are near. */
  private static final double NEAR = 8;

  /** The distance of outside origins whose errors the boxes include. */
  private static final double OUTSIDE = 0x1p23;

  /** Beyond this distance, floats have no useful precision. */
  static final double REACH = 0x1p40;

  final double centerX;
  final double centerY;
  final double centerZ;

  /** A power of two. */
  final double scale;

  /** The largest absolute world coordinate of the center, in units of this space. */
  final double centerReach;

  /** A bound of the world coordinates of near origins and the center, in units of this space. */
  final double nearReach;

  /**
   * The largest world coordinate of an outside origin and of the center, in units of this space,
   * whose errors the boxes include; 0 if floats are out of reach.
   */
  final double coveredReach;

  /** Whether floats are in reach: the bound of an inside origin is at most {@link #REACH}. */
  private final boolean isInReach;

  /** The margin of boxes; 0 if floats are out of reach. */
  private final double slack;

  /**
   * Creates the space of a box.
   *
   * @param box minimum and maximum on x, y, z of all items, in world space
   */
  UnitSpace(double[] box) {
    centerX = .5 * box[0] + .5 * box[1];
    centerY = .5 * box[2] + .5 * box[3];
    centerZ = .5 * box[4] + .5 * box[5];
    double half = Math.max(box[1] - centerX, Math.max(box[3] - centerY, box[5] - centerZ));
    scale = Math.scalb(1.0, -1 - Math.getExponent(half));
    centerReach = scale * Axes.largest(centerX, centerY, centerZ);
    double worldReach = 2 * (centerReach + INSIDE);
    nearReach = 2 * centerReach + NEAR + INSIDE;
    isInReach = worldReach <= REACH;
    coveredReach = isInReach ? worldReach + OUTSIDE : 0;
    slack = isInReach ? slack(INSIDE, coveredReach) : 0;
  }

  /** Returns whether a point of this space is near its center, with floats in reach. */
  boolean isNear(double x, double y, double z) {
    return Math.abs(x) <= NEAR && Math.abs(y) <= NEAR && Math.abs(z) <= NEAR && isInReach;
  }

  /** Returns whether a point of this space is inside. */
  static boolean isInside(double x, double y, double z) {
    return Math.abs(x) <= INSIDE && Math.abs(y) <= INSIDE && Math.abs(z) <= INSIDE;
  }

  /**
   * Returns a bound of the joint error of box coordinates and ray origins.
   *
   * @param reach the largest absolute coordinate of the origin in this space
   * @param worldReach the largest absolute world coordinate of the origin and the center, in units
   *     of this space
   */
  static double slack(double reach, double worldReach) {
    return 9 * 0x1p-24 * (1 + reach) + 0x1p-46 * worldReach;
  }

  private double center(int axis) {
    return axis == 0 ? centerX : axis == 1 ? centerY : centerZ;
  }

  /** Returns a world coordinate in this space, rounded to the nearest float. */
  float nearest(int axis, double coordinate) {
    return (float) ((coordinate - center(axis)) * scale);
  }

  /** Returns a world coordinate in this space, lowered by the error bound. */
  float down(int axis, double coordinate) {
    double x = (coordinate - center(axis)) * scale - slack;
    float rounded = (float) x;
    return rounded > x ? Math.nextDown(rounded) : rounded;
  }

  /** Returns a world coordinate in this space, raised by the error bound. */
  float up(int axis, double coordinate) {
    double x = (coordinate - center(axis)) * scale + slack;
    float rounded = (float) x;
    return rounded < x ? Math.nextUp(rounded) : rounded;
  }
}
