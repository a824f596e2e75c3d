package io.github.lumbre.math;

/**
 * An axis-aligned bounding box. {@link #EMPTY} contains no point; a box may have zero thickness.
 * Immutable.
 */
public record Bounds3(Vec3 min, Vec3 max) {
  private static final double INF = Double.POSITIVE_INFINITY;

  /** The empty box, the neutral element of {@link #union}. */
  public static final Bounds3 EMPTY =
      new Bounds3(new Vec3(INF, INF, INF), new Vec3(-INF, -INF, -INF));

  /** Returns the smallest box that contains all the points. */
  public static Bounds3 of(Vec3... points) {
    Bounds3 bounds = EMPTY;
    for (Vec3 point : points) {
      bounds = bounds.union(point);
    }
    return bounds;
  }

  /** Returns the smallest box around this box and a point. */
  public Bounds3 union(Vec3 p) {
    return new Bounds3(
        new Vec3(Math.min(min.x(), p.x()), Math.min(min.y(), p.y()), Math.min(min.z(), p.z())),
        new Vec3(Math.max(max.x(), p.x()), Math.max(max.y(), p.y()), Math.max(max.z(), p.z())));
  }

  /** Returns the smallest box around both boxes. */
  public Bounds3 union(Bounds3 o) {
    return o.isEmpty() ? this : union(o.min).union(o.max);
  }

  /** Returns whether the box has no points. */
  public boolean isEmpty() {
    return !(min.x() <= max.x() && min.y() <= max.y() && min.z() <= max.z());
  }

  /**
   * Returns whether the segment between two points meets the box, by the separating axis theorem
   * (Ericson 2005, "Real-Time Collision Detection", sec. 5.3.3). True for an infinite box.
   */
  public boolean meets(Vec3 a, Vec3 b) {
    double ex = max.x() - min.x();
    double ey = max.y() - min.y();
    double ez = max.z() - min.z();
    // Twice the vector from the box's center to the segment's; NaN for an infinite box.
    double cx = a.x() + b.x() - (min.x() + max.x());
    double cy = a.y() + b.y() - (min.y() + max.y());
    double cz = a.z() + b.z() - (min.z() + max.z());
    double dx = b.x() - a.x();
    double dy = b.y() - a.y();
    double dz = b.z() - a.z();
    double lx = Math.abs(dx);
    double ly = Math.abs(dy);
    double lz = Math.abs(dz);
    boolean isBeside = Math.abs(cx) > ex + lx || Math.abs(cy) > ey + ly || Math.abs(cz) > ez + lz;
    return !isBeside
        && !(Math.abs(cy * dz - cz * dy) > ey * lz + ez * ly)
        && !(Math.abs(cz * dx - cx * dz) > ez * lx + ex * lz)
        && !(Math.abs(cx * dy - cy * dx) > ex * ly + ey * lx);
  }

  /** Returns whether all coordinates of the corners are finite. */
  public boolean isFinite() {
    return min.isFinite() && max.isFinite();
  }

  /** Returns the corner with the given number, 0 to 7: bit k selects the maximum on axis k. */
  public Vec3 corner(int number) {
    return new Vec3(
        (number & 1) == 0 ? min.x() : max.x(),
        (number & 2) == 0 ? min.y() : max.y(),
        (number & 4) == 0 ? min.z() : max.z());
  }

  /** Returns the point in the middle of the box. */
  public Vec3 center() {
    return min.times(.5).plus(max.times(.5));
  }

  /** Returns the radius of the sphere around {@link #center} through the corners; 0 if empty. */
  public double radius() {
    return isEmpty() ? 0 : max.times(.5).minus(min.times(.5)).length();
  }
}
