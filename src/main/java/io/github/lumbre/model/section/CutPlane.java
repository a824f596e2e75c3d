package io.github.lumbre.model.section;

import io.github.lumbre.math.Vec3;

/**
 * A plane in a model's world space, with axes for what lies in it.
 *
 * @param point on the plane
 * @param normal unit vector to the side that is removed
 * @param right unit vector in the plane: horizontal where the plane is upright
 * @param up unit vector in the plane, so that right, up and normal are right-handed
 */
record CutPlane(Vec3 point, Vec3 normal, Vec3 right, Vec3 up) {
  /** Distances are computed in this scale, so that they do not overflow. */
  private static final double SCALE = 0x1p-8;

  /** The largest y of normals of upright planes. */
  private static final double UPRIGHT = .999;

  /** Returns the plane through a point with a unit normal. */
  static CutPlane of(Vec3 point, Vec3 normal) {
    Vec3 above = Math.abs(normal.y()) > UPRIGHT ? Vec3.Z.negated() : Vec3.Y;
    Vec3 right = above.cross(normal).normalized();
    return new CutPlane(point, normal, right, normal.cross(right));
  }

  /**
   * Returns a number that is proportional to the distance of a point in front of the plane; it is
   * negative behind, on the side that is kept.
   */
  double side(Vec3 p) {
    double x = p.x() * SCALE - point.x() * SCALE;
    double y = p.y() * SCALE - point.y() * SCALE;
    double z = p.z() * SCALE - point.z() * SCALE;
    return normal.x() * x + normal.y() * y + normal.z() * z;
  }

  /** Returns the coordinate of a point along {@link #right}. */
  double u(Vec3 p) {
    return right.dot(p);
  }

  /** Returns the coordinate of a point along {@link #up}. */
  double v(Vec3 p) {
    return up.dot(p);
  }

  /** Returns the point of the plane with some coordinates. */
  Vec3 at(double u, double v) {
    return point.plus(u - u(point), right).plus(v - v(point), up);
  }
}
