package io.github.lumbre.math;

import io.github.lumbre.math.internal.Elementary;
import java.util.List;

/**
 * An affine transform from an object's local space to world space: a 3×3 matrix and a translation,
 * acting on column vectors, with its inverse. Immutable.
 *
 * <p>Rotations in scene files are in degrees, about z first, then x, then y: R = Ry·Rx·Rz. {@code
 * Rx(90°)} takes +z to −y, and {@code Ry(90°)} takes +z to +x.
 */
public final class Transform {
  /** Leaves every point where it is. */
  public static final Transform IDENTITY = translation(Vec3.ZERO);

  /**
   * Bound of the relative rounding error of a mapped point: the error of each coordinate is below
   * this factor times the sum of the absolute values of its terms. The factor leaves room for
   * mapping the result back (two products of three terms and their sums: PBRT 4e, sec. 6.8.1).
   */
  private static final double ROUNDING = 32 * 0x1p-52;

  /** Angles whose cosine is larger than this are not right angles. */
  private static final double RIGHT_ANGLE = 1e-12;

  // Row-major: the image of (x, y, z) is (m00 x + m01 y + m02 z + tx, …).
  private final double m00, m01, m02, tx;
  private final double m10, m11, m12, ty;
  private final double m20, m21, m22, tz;
  // The inverse of the 3×3 part.
  private final double i00, i01, i02;
  private final double i10, i11, i12;
  private final double i20, i21, i22;
  private final double determinant;

  private Transform(Matrix3 matrix, Vec3 translation, Matrix3 inverse, double determinant) {
    m00 = matrix.row0().x();
    m01 = matrix.row0().y();
    m02 = matrix.row0().z();
    m10 = matrix.row1().x();
    m11 = matrix.row1().y();
    m12 = matrix.row1().z();
    m20 = matrix.row2().x();
    m21 = matrix.row2().y();
    m22 = matrix.row2().z();
    tx = translation.x();
    ty = translation.y();
    tz = translation.z();
    i00 = inverse.row0().x();
    i01 = inverse.row0().y();
    i02 = inverse.row0().z();
    i10 = inverse.row1().x();
    i11 = inverse.row1().y();
    i12 = inverse.row1().z();
    i20 = inverse.row2().x();
    i21 = inverse.row2().y();
    i22 = inverse.row2().z();
    this.determinant = determinant;
  }

  /** Returns the transform that adds an offset to points. */
  public static Transform translation(Vec3 offset) {
    return new Transform(Matrix3.IDENTITY, offset, Matrix3.IDENTITY, 1);
  }

  /** Returns the transform that multiplies each coordinate by its factor, which is not 0. */
  public static Transform scale(Vec3 factors) {
    Vec3 inverse = new Vec3(1 / factors.x(), 1 / factors.y(), 1 / factors.z());
    return new Transform(
        Matrix3.diagonal(factors),
        Vec3.ZERO,
        Matrix3.diagonal(inverse),
        factors.x() * factors.y() * factors.z());
  }

  /** Returns Ry·Rx·Rz for three angles in degrees. */
  public static Transform rotationDegrees(Vec3 degrees) {
    double cx = Elementary.cosDegrees(degrees.x());
    double sx = Elementary.sinDegrees(degrees.x());
    double cy = Elementary.cosDegrees(degrees.y());
    double sy = Elementary.sinDegrees(degrees.y());
    double cz = Elementary.cosDegrees(degrees.z());
    double sz = Elementary.sinDegrees(degrees.z());
    Matrix3 ry = new Matrix3(new Vec3(cy, 0, sy), Vec3.Y, new Vec3(-sy, 0, cy));
    Matrix3 rx = new Matrix3(Vec3.X, new Vec3(0, cx, -sx), new Vec3(0, sx, cx));
    Matrix3 rz = new Matrix3(new Vec3(cz, -sz, 0), new Vec3(sz, cz, 0), Vec3.Z);
    Matrix3 matrix = ry.times(rx).times(rz);
    return new Transform(matrix, Vec3.ZERO, matrix.inverseNear(matrix.transposed()), 1);
  }

  /**
   * Returns the map that takes the local axes to three vectors and the local origin to a point. It
   * is not {@linkplain #isInvertible invertible} if the vectors lie in one plane.
   */
  public static Transform ofAxes(Vec3 x, Vec3 y, Vec3 z, Vec3 origin) {
    Matrix3 matrix = new Matrix3(x, y, z).transposed();
    double determinant = x.dot(y.cross(z));
    double factor = 1 / determinant;
    Matrix3 cofactors =
        new Matrix3(y.cross(z).times(factor), z.cross(x).times(factor), x.cross(y).times(factor));
    return new Transform(matrix, origin, matrix.inverseNear(cofactors), determinant);
  }

  /**
   * Returns the map that rotates about the local origin and then moves it to a point.
   *
   * @param degrees as in {@link #rotationDegrees}
   */
  public static Transform placed(Vec3 position, Vec3 degrees) {
    return translation(position).times(rotationDegrees(degrees));
  }

  /** Returns the map from a frame's local space at a point to world space. */
  public static Transform ofFrame(Frame axes, Vec3 origin) {
    return ofAxes(axes.tangent(), axes.bitangent(), axes.normal(), origin);
  }

  /** The number of values of {@link #toArray}. */
  public static final int VALUES = 22;

  /**
   * Returns all values of the transform: the 3×3 matrix and its inverse row by row, the
   * translation, and the determinant.
   */
  public double[] toArray() {
    return new double[] {
      m00, m01, m02, m10, m11, m12, m20, m21, m22,
      i00, i01, i02, i10, i11, i12, i20, i21, i22,
      tx, ty, tz, determinant
    };
  }

  /**
   * Returns the transform with the values of {@link #toArray}, bit for bit. The caller answers for
   * the inverse.
   *
   * @throws IllegalArgumentException if the number of values is wrong
   */
  public static Transform ofArray(double[] v) {
    if (v.length != VALUES) {
      throw new IllegalArgumentException(
          "values: expected " + VALUES + " numbers, found " + v.length);
    }
    return new Transform(
        Matrix3.ofRows(v, 0), new Vec3(v[18], v[19], v[20]), Matrix3.ofRows(v, 9), v[21]);
  }

  /** Returns the map that applies {@code inner} first and then this. */
  public Transform times(Transform inner) {
    Matrix3 product = matrix().times(inner.matrix());
    return new Transform(
        product,
        point(new Vec3(inner.tx, inner.ty, inner.tz)),
        product.inverseNear(inner.inverse().times(inverse())),
        determinant * inner.determinant);
  }

  private Matrix3 matrix() {
    return new Matrix3(new Vec3(m00, m01, m02), new Vec3(m10, m11, m12), new Vec3(m20, m21, m22));
  }

  private Matrix3 inverse() {
    return new Matrix3(new Vec3(i00, i01, i02), new Vec3(i10, i11, i12), new Vec3(i20, i21, i22));
  }

  /**
   * Returns whether the transform is invertible: its determinant is not 0, and every number of it
   * and of its inverse is finite.
   */
  public boolean isInvertible() {
    double sum =
        i00 + i01 + i02 + i10 + i11 + i12 + i20 + i21 + i22 + m00 + m01 + m02 + m10 + m11 + m12
            + m20 + m21 + m22 + tx + ty + tz;
    return determinant != 0 && Double.isFinite(determinant) && Double.isFinite(sum);
  }

  /**
   * Returns the determinant of the 3×3 matrix: the factor by which the transform scales volumes,
   * negative if it mirrors.
   */
  public double determinant() {
    return determinant;
  }

  /** Returns whether the transform changes handedness. */
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

  /** Returns the world position of (x, 0, z), faster than {@link #point}. */
  public Vec3 pointInPlane(double x, double z) {
    return new Vec3(m00 * x + m02 * z + tx, m10 * x + m12 * z + ty, m20 * x + m22 * z + tz);
  }

  /**
   * Returns a bound for the rounding error of {@link #point}{@code (p)}, as a distance along a unit
   * world normal from the exact surface. p itself must be accurate to a few ulp.
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

  /**
   * Returns a bound for the error of mapping a world point to local space and back, as a distance
   * along a unit world normal. If the transform skews, this error is far larger than the rounding
   * error of either mapping.
   */
  public double mappingError(Vec3 p, Vec3 worldNormal) {
    double px = Math.abs(p.x() - tx);
    double py = Math.abs(p.y() - ty);
    double pz = Math.abs(p.z() - tz);
    double ex = Math.abs(i00) * px + Math.abs(i01) * py + Math.abs(i02) * pz;
    double ey = Math.abs(i10) * px + Math.abs(i11) * py + Math.abs(i12) * pz;
    double ez = Math.abs(i20) * px + Math.abs(i21) * py + Math.abs(i22) * pz;
    return ROUNDING
        * (Math.abs(worldNormal.x())
                * (Math.abs(m00) * ex + Math.abs(m01) * ey + Math.abs(m02) * ez)
            + Math.abs(worldNormal.y())
                * (Math.abs(m10) * ex + Math.abs(m11) * ey + Math.abs(m12) * ez)
            + Math.abs(worldNormal.z())
                * (Math.abs(m20) * ex + Math.abs(m21) * ey + Math.abs(m22) * ez));
  }

  /**
   * Returns whether the transform skews: the images of the local axes are not perpendicular, by
   * more than rounding.
   */
  public boolean isSkewed() {
    Vec3 x = vector(Vec3.X);
    Vec3 y = vector(Vec3.Y);
    Vec3 z = vector(Vec3.Z);
    return Math.abs(x.dot(y)) > RIGHT_ANGLE * x.length() * y.length()
        || Math.abs(y.dot(z)) > RIGHT_ANGLE * y.length() * z.length()
        || Math.abs(z.dot(x)) > RIGHT_ANGLE * z.length() * x.length();
  }

  /** Returns the world direction of a local one; its length is scaled by the transform. */
  public Vec3 vector(Vec3 v) {
    return new Vec3(
        m00 * v.x() + m01 * v.y() + m02 * v.z(),
        m10 * v.x() + m11 * v.y() + m12 * v.z(),
        m20 * v.x() + m21 * v.y() + m22 * v.z());
  }

  /**
   * Returns the unit world normal of a local surface normal, by the inverse transpose. An outward
   * normal stays outward, even if the transform mirrors.
   */
  public Vec3 normal(Vec3 n) {
    return covector(n).normalized();
  }

  /** Returns the inverse transpose of the 3×3 matrix times a vector: a normal of any length. */
  public Vec3 covector(Vec3 n) {
    return new Vec3(
        i00 * n.x() + i10 * n.y() + i20 * n.z(),
        i01 * n.x() + i11 * n.y() + i21 * n.z(),
        i02 * n.x() + i12 * n.y() + i22 * n.z());
  }

  /** Returns the local position of a world one. */
  public Vec3 inversePoint(Vec3 p) {
    return inverseVector(new Vec3(p.x() - tx, p.y() - ty, p.z() - tz));
  }

  /** Returns the local direction of a world one; its length is scaled by the inverse transform. */
  public Vec3 inverseVector(Vec3 v) {
    return new Vec3(
        i00 * v.x() + i01 * v.y() + i02 * v.z(),
        i10 * v.x() + i11 * v.y() + i12 * v.z(),
        i20 * v.x() + i21 * v.y() + i22 * v.z());
  }

  /** Returns the local x of a world position given by its coordinates; allocates nothing. */
  public double inversePointX(double x, double y, double z) {
    return inverseVectorX(x - tx, y - ty, z - tz);
  }

  /** Returns the local y of a world position given by its coordinates; allocates nothing. */
  public double inversePointY(double x, double y, double z) {
    return inverseVectorY(x - tx, y - ty, z - tz);
  }

  /** Returns the local z of a world position given by its coordinates; allocates nothing. */
  public double inversePointZ(double x, double y, double z) {
    return inverseVectorZ(x - tx, y - ty, z - tz);
  }

  /** Returns the local x of a world direction given by its coordinates; allocates nothing. */
  public double inverseVectorX(double x, double y, double z) {
    return i00 * x + i01 * y + i02 * z;
  }

  /** Returns the local y of a world direction given by its coordinates; allocates nothing. */
  public double inverseVectorY(double x, double y, double z) {
    return i10 * x + i11 * y + i12 * z;
  }

  /** Returns the local z of a world direction given by its coordinates; allocates nothing. */
  public double inverseVectorZ(double x, double y, double z) {
    return i20 * x + i21 * y + i22 * z;
  }

  /** Returns the world-space bounding box of a transformed local box. */
  public Bounds3 bounds(Bounds3 local) {
    Bounds3 world = Bounds3.EMPTY;
    for (int corner = 0; corner < 8; corner++) {
      world = world.union(point(local.corner(corner)));
    }
    return world;
  }

  /** Returns the three rows of the matrix, for people. */
  @Override
  public String toString() {
    return List.of(
            List.of(m00, m01, m02, tx), List.of(m10, m11, m12, ty), List.of(m20, m21, m22, tz))
        .toString();
  }
}
