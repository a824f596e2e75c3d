package generator;

/** Cylindrical coordinates around the line from {@code a} to {@code b}, for painting limbs. */
final class Bone {
  final Vec a;
  final Vec b;
  final Vec axis;
  private final Vec front;
  private final Vec side;

  /** Angle 0 lies on the side of the figure's front, -z, and grows towards +x. */
  Bone(Vec a, Vec b) {
    this(a, b, new Vec(0, 0, -1));
  }

  Bone(Vec a, Vec b, Vec zero) {
    this.a = a;
    this.b = b;
    axis = b.minus(a).normalized();
    front = zero.minus(axis.times(zero.dot(axis))).normalized();
    Vec s = front.cross(axis);
    side = s.x() < 0 ? s.times(-1) : s;
  }

  /** The point on the axis at this distance from {@code a}. */
  Vec point(double distance) {
    return a.plus(axis.times(distance));
  }

  /** The distance along the axis from {@code a}. */
  double along(Vec p) {
    return p.minus(a).dot(axis);
  }

  /** The angle around the axis, in (-pi, pi]. */
  double around(Vec p) {
    Vec d = p.minus(a);
    return StrictMath.atan2(d.dot(side), d.dot(front));
  }

  /** The distance from the axis. */
  double radius(Vec p) {
    Vec d = p.minus(a);
    double t = d.dot(axis);
    return Math.sqrt(Math.max(0, d.dot(d) - t * t));
  }

  /** The distance to the nearest of {@code count} points in a ring at this distance along. */
  double toRing(Vec p, double along, int count) {
    double turn = around(p) / (2 * Math.PI) * count;
    double arc = (turn - Math.rint(turn)) / count * 2 * Math.PI * radius(p);
    double t = along(p) - along;
    return Math.sqrt(arc * arc + t * t);
  }
}
