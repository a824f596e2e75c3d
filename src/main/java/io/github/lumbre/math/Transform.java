package io.github.lumbre.math;

/**
 * An invertible affine map from an object's local space to the world: a 3×3 matrix and a
 * translation, acting on column vectors, and its inverse.
 *
 * <p>Scene files write rotations in degrees about z first, then x, then y: R = Ry·Rx·Rz; {@code
 * Rx(90°)} takes +z to −y and {@code Ry(90°)} takes +z to +x.
 */
public final class Transform {
  public static final Transform IDENTITY =
      new Transform(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0);

  /**
   * The error of a mapped point's coordinate is below this times the sum of the absolute terms
   * that formed it, with room for an inverse mapping of the result (two products of three terms
   * and their sums: PBRT 4e, sec. 6.8.1).
   */
  private static final double ROUNDING = 32 * 0x1p-52;

  // Row-major: the image of (x, y, z) is (m00 x + m01 y + m02 z + tx, …).
  private final double m00, m01, m02, tx;
  private final double m10, m11, m12, ty;
  private final double m20, m21, m22, tz;
  // The inverse of the 3×3 part.
  private final double i00, i01, i02;
  private final double i10, i11, i12;
  private final double i20, i21, i22;
  private final double determinant;

  private Transform(
      double m00, double m01, double m02, double tx,
      double m10, double m11, double m12, double ty,
      double m20, double m21, double m22, double tz) {
    this.m00 = m00;
    this.m01 = m01;
    this.m02 = m02;
    this.tx = tx;
    this.m10 = m10;
    this.m11 = m11;
    this.m12 = m12;
    this.ty = ty;
    this.m20 = m20;
    this.m21 = m21;
    this.m22 = m22;
    this.tz = tz;
    double c00 = m11 * m22 - m12 * m21;
    double c01 = m12 * m20 - m10 * m22;
    double c02 = m10 * m21 - m11 * m20;
    determinant = m00 * c00 + m01 * c01 + m02 * c02;
    double f = 1 / determinant;
    i00 = c00 * f;
    i01 = (m02 * m21 - m01 * m22) * f;
    i02 = (m01 * m12 - m02 * m11) * f;
    i10 = c01 * f;
    i11 = (m00 * m22 - m02 * m20) * f;
    i12 = (m02 * m10 - m00 * m12) * f;
    i20 = c02 * f;
    i21 = (m01 * m20 - m00 * m21) * f;
    i22 = (m00 * m11 - m01 * m10) * f;
  }

  public static Transform translation(Vec3 offset) {
    return new Transform(1, 0, 0, offset.x(), 0, 1, 0, offset.y(), 0, 0, 1, offset.z());
  }

  public static Transform scale(Vec3 factors) {
    return new Transform(factors.x(), 0, 0, 0, 0, factors.y(), 0, 0, 0, 0, factors.z(), 0);
  }

  /** Returns Ry·Rx·Rz for three angles in degrees. */
  public static Transform rotationDegrees(Vec3 degrees) {
    double cx = Elementary.cosDegrees(degrees.x());
    double sx = Elementary.sinDegrees(degrees.x());
    double cy = Elementary.cosDegrees(degrees.y());
    double sy = Elementary.sinDegrees(degrees.y());
    double cz = Elementary.cosDegrees(degrees.z());
    double sz = Elementary.sinDegrees(degrees.z());
    Transform ry = new Transform(cy, 0, sy, 0, 0, 1, 0, 0, -sy, 0, cy, 0);
    Transform rx = new Transform(1, 0, 0, 0, 0, cx, -sx, 0, 0, sx, cx, 0);
    Transform rz = new Transform(cz, -sz, 0, 0, sz, cz, 0, 0, 0, 0, 1, 0);
    return ry.times(rx).times(rz);
  }

  /** Returns the map that applies {@code inner} first and then this. */
  public Transform times(Transform inner) {
    Vec3 x = vector(inner.m00, inner.m10, inner.m20);
    Vec3 y = vector(inner.m01, inner.m11, inner.m21);
    Vec3 z = vector(inner.m02, inner.m12, inner.m22);
    Vec3 t = vector(inner.tx, inner.ty, inner.tz);
    return new Transform(
        x.x(), y.x(), z.x(), t.x() + tx,
        x.y(), y.y(), z.y(), t.y() + ty,
        x.z(), y.z(), z.z(), t.z() + tz);
  }

  /** Tells whether the map can be undone: every number of it and of its inverse is finite. */
  public boolean isInvertible() {
    double sum =
        i00 + i01 + i02 + i10 + i11 + i12 + i20 + i21 + i22 + m00 + m01 + m02 + m10 + m11 + m12
            + m20 + m21 + m22 + tx + ty + tz;
    return determinant != 0 && Double.isFinite(determinant) && Double.isFinite(sum);
  }

  /** Returns the determinant of the 3×3 part: the factor by which the map scales volumes. */
  public double determinant() {
    return determinant;
  }

  /** Tells whether the map turns a left hand into a right one. */
  public boolean isMirroring() {
    return determinant < 0;
  }

  /** Returns the world position of a local one. */
  public Vec3 point(Vec3 p) {
    return new Vec3(
        m00 * p.x() + m01 * p.y() + m02 * p.z() + tx,
        m10 * p.x() + m11 * p.y() + m12 * p.z() + ty,
        m20 * p.x() + m21 * p.y() + m22 * p.z() + tz);
  }

  /**
   * Returns a bound for the distance, along a unit world normal, between {@link #point}{@code (p)}
   * as computed and the exact surface that p stands for, p itself being right to a few ulp.
   */
  public double pointError(Vec3 p, Vec3 worldNormal) {
    double px = Math.abs(p.x());
    double py = Math.abs(p.y());
    double pz = Math.abs(p.z());
    double ex = Math.abs(m00) * px + Math.abs(m01) * py + Math.abs(m02) * pz + Math.abs(tx);
    double ey = Math.abs(m10) * px + Math.abs(m11) * py + Math.abs(m12) * pz + Math.abs(ty);
    double ez = Math.abs(m20) * px + Math.abs(m21) * py + Math.abs(m22) * pz + Math.abs(tz);
    return ROUNDING
        * (Math.abs(worldNormal.x()) * ex
            + Math.abs(worldNormal.y()) * ey
            + Math.abs(worldNormal.z()) * ez);
  }

  /** Returns the world direction of a local one; length scales along. */
  public Vec3 vector(Vec3 v) {
    return vector(v.x(), v.y(), v.z());
  }

  private Vec3 vector(double x, double y, double z) {
    return new Vec3(
        m00 * x + m01 * y + m02 * z, m10 * x + m11 * y + m12 * z, m20 * x + m21 * y + m22 * z);
  }

  /**
   * Returns the unit world normal of a local surface normal, by the inverse transpose. Outside
   * stays outside, in mirroring maps too.
   */
  public Vec3 normal(Vec3 n) {
    return new Vec3(
            i00 * n.x() + i10 * n.y() + i20 * n.z(),
            i01 * n.x() + i11 * n.y() + i21 * n.z(),
            i02 * n.x() + i12 * n.y() + i22 * n.z())
        .normalized();
  }

  /** Returns the local position of a world one. */
  public Vec3 inversePoint(Vec3 p) {
    return inverseVector(new Vec3(p.x() - tx, p.y() - ty, p.z() - tz));
  }

  /** Returns the local direction of a world one; length scales along. */
  public Vec3 inverseVector(Vec3 v) {
    return new Vec3(
        i00 * v.x() + i01 * v.y() + i02 * v.z(),
        i10 * v.x() + i11 * v.y() + i12 * v.z(),
        i20 * v.x() + i21 * v.y() + i22 * v.z());
  }

  /** Returns the local x of a world position given by its coordinates; makes no object. */
  public double inversePointX(double x, double y, double z) {
    return inverseVectorX(x - tx, y - ty, z - tz);
  }

  /** Returns the local y of a world position given by its coordinates; makes no object. */
  public double inversePointY(double x, double y, double z) {
    return inverseVectorY(x - tx, y - ty, z - tz);
  }

  /** Returns the local z of a world position given by its coordinates; makes no object. */
  public double inversePointZ(double x, double y, double z) {
    return inverseVectorZ(x - tx, y - ty, z - tz);
  }

  /** Returns the local x of a world direction given by its coordinates; makes no object. */
  public double inverseVectorX(double x, double y, double z) {
    return i00 * x + i01 * y + i02 * z;
  }

  /** Returns the local y of a world direction given by its coordinates; makes no object. */
  public double inverseVectorY(double x, double y, double z) {
    return i10 * x + i11 * y + i12 * z;
  }

  /** Returns the local z of a world direction given by its coordinates; makes no object. */
  public double inverseVectorZ(double x, double y, double z) {
    return i20 * x + i21 * y + i22 * z;
  }

  /** Returns the box around the image of a box. */
  public Bounds3 bounds(Bounds3 local) {
    Bounds3 world = Bounds3.EMPTY;
    for (int corner = 0; corner < 8; corner++) {
      world = world.union(point(local.corner(corner)));
    }
    return world;
  }
}
