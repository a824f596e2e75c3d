package io.github.lumbre.math;

/** A 3×3 matrix that acts on column vectors; used to build {@link Transform}. Immutable. */
record Matrix3(Vec3 row0, Vec3 row1, Vec3 row2) {
  /** Twice the largest relative error of a sum of three products of rounded factors. */
  private static final double ROUNDING = 8 * 0x1p-52;

  static final Matrix3 IDENTITY = diagonal(new Vec3(1, 1, 1));

  static Matrix3 diagonal(Vec3 d) {
    return new Matrix3(new Vec3(d.x(), 0, 0), new Vec3(0, d.y(), 0), new Vec3(0, 0, d.z()));
  }

  /** Returns the matrix of nine values, row by row. */
  static Matrix3 ofRows(double[] values, int start) {
    return new Matrix3(
        new Vec3(values[start], values[start + 1], values[start + 2]),
        new Vec3(values[start + 3], values[start + 4], values[start + 5]),
        new Vec3(values[start + 6], values[start + 7], values[start + 8]));
  }

  Vec3 times(Vec3 v) {
    return new Vec3(row0.dot(v), row1.dot(v), row2.dot(v));
  }

  Matrix3 times(Matrix3 o) {
    Matrix3 columns = o.transposed();
    return new Matrix3(columns.times(row0), columns.times(row1), columns.times(row2));
  }

  Matrix3 plus(Matrix3 o) {
    return new Matrix3(row0.plus(o.row0), row1.plus(o.row1), row2.plus(o.row2));
  }

  Matrix3 minus(Matrix3 o) {
    return new Matrix3(row0.minus(o.row0), row1.minus(o.row1), row2.minus(o.row2));
  }

  Matrix3 transposed() {
    return new Matrix3(
        new Vec3(row0.x(), row1.x(), row2.x()),
        new Vec3(row0.y(), row1.y(), row2.y()),
        new Vec3(row0.z(), row1.z(), row2.z()));
  }

  private Matrix3 absolute() {
    return new Matrix3(absolute(row0), absolute(row1), absolute(row2));
  }

  private static Vec3 absolute(Vec3 v) {
    return new Vec3(Math.abs(v.x()), Math.abs(v.y()), Math.abs(v.z()));
  }

  /**
   * Returns the inverse of this matrix M from an approximate inverse X, by one step of Newton's
   * iteration: X + (I − X·M)·X (Schulz 1933). The result is as accurate as the condition of the
   * matrix allows. Cofactors divided by the determinant would be less accurate for matrices with
   * very small axes.
   *
   * <p>A guess that is accurate up to rounding is returned unchanged. Scaling a matrix by a power
   * of two therefore scales its inverse and changes no digit.
   */
  Matrix3 inverseNear(Matrix3 guess) {
    Matrix3 residual = IDENTITY.minus(guess.times(this));
    Matrix3 rounding = guess.absolute().times(absolute());
    boolean right =
        isWithin(residual.row0, rounding.row0)
            && isWithin(residual.row1, rounding.row1)
            && isWithin(residual.row2, rounding.row2);
    return right ? guess : guess.plus(residual.times(guess));
  }

  private static boolean isWithin(Vec3 residual, Vec3 rounding) {
    return Math.abs(residual.x()) <= ROUNDING * rounding.x()
        && Math.abs(residual.y()) <= ROUNDING * rounding.y()
        && Math.abs(residual.z()) <= ROUNDING * rounding.z();
  }
}
