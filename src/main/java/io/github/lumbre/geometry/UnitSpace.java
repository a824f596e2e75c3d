package io.github.lumbre.geometry;

/**
 * The space in which a hierarchy keeps floats: moved and scaled, by a power of two, so that all
 * boxes lie in [-1, 1]³. There an error in floats is an absolute one, wherever and however large
 * the scene is.
 */
final class UnitSpace {
  /** Origins no farther from the centre, by each coordinate, are inside, or barely outside. */
  static final double INSIDE = 1 + 0x1p-4;

  /** Beyond this distance floats tell nothing. */
  static final double REACH = 0x1p40;

  final double centreX;
  final double centreY;
  final double centreZ;

  /** A power of two. */
  final double scale;

  /** The largest coordinate of the centre, in units of this space. */
  final double centreReach;

  /** A bound of what an origin inside was computed from: its coordinates and the centre's. */
  final double worldReach;

  /** Whether that is in the reach of floats. */
  private final boolean isInReach;

  /** What boxes are widened by, for rays from inside; 0 if that is out of reach. */
  private final double slack;

  /**
   * @param box minimum and maximum on x, y, z of all there is
   */
  UnitSpace(double[] box) {
    centreX = .5 * box[0] + .5 * box[1];
    centreY = .5 * box[2] + .5 * box[3];
    centreZ = .5 * box[4] + .5 * box[5];
    double half = Math.max(box[1] - centreX, Math.max(box[3] - centreY, box[5] - centreZ));
    scale = Math.scalb(1.0, -1 - Math.getExponent(half));
    centreReach = scale * Axes.largest(centreX, centreY, centreZ);
    worldReach = 2 * (centreReach + INSIDE);
    isInReach = worldReach <= REACH;
    slack = isInReach ? slack(INSIDE, worldReach) : 0;
  }

  /** Tells whether a point of this space is inside, and in the reach of floats. */
  boolean isInside(double x, double y, double z) {
    return Math.abs(x) <= INSIDE && Math.abs(y) <= INSIDE && Math.abs(z) <= INSIDE && isInReach;
  }

  /**
   * Returns what coordinates of boxes and of a ray's origin may be wrong by together.
   *
   * @param reach how far the origin is from the centre, by its largest coordinate
   * @param worldReach the largest of the coordinates that the origin was computed from
   */
  static double slack(double reach, double worldReach) {
    return 0x1p-22 * (1 + reach) + 0x1p-46 * worldReach;
  }

  private double centre(int axis) {
    return axis == 0 ? centreX : axis == 1 ? centreY : centreZ;
  }

  /** Returns a coordinate of this space, rounded to the nearest float. */
  float nearest(int axis, double coordinate) {
    return (float) ((coordinate - centre(axis)) * scale);
  }

  /** Returns a coordinate of this space, below by what rays from inside may be wrong by. */
  float down(int axis, double coordinate) {
    double x = (coordinate - centre(axis)) * scale - slack;
    float rounded = (float) x;
    return rounded > x ? Math.nextDown(rounded) : rounded;
  }

  /** Returns a coordinate of this space, above by what rays from inside may be wrong by. */
  float up(int axis, double coordinate) {
    double x = (coordinate - centre(axis)) * scale + slack;
    float rounded = (float) x;
    return rounded < x ? Math.nextUp(rounded) : rounded;
  }
}
