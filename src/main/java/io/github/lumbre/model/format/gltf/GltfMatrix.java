package io.github.lumbre.model.format.gltf;

import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.Arrays;

/** An affine map that need not be invertible. Immutable. */
final class GltfMatrix {
  static final GltfMatrix IDENTITY = new GltfMatrix(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0);

  private static final int COLUMNS = 4;

  /** The largest deviation of the last row from 0, 0, 0, 1, as left by rounding. */
  private static final double ROUNDING = 1e-4;

  /**
   * The smallest extent of a map onto a solid, relative to the second one: well above the rounding
   * of files with 32-bit floats.
   */
  private static final double THINNEST = 0x1p-20;

  /** The smallest second extent relative to the first one: above the rounding of products. */
  private static final double NARROWEST = 0x1p-45;

  // Three rows of four numbers.
  private final double[] m;

  private GltfMatrix(double... rows) {
    m = rows;
  }

  /**
   * Returns a 4×4 matrix of a file, stored column by column.
   *
   * @param at index of the first number
   */
  static GltfMatrix ofColumns(double[] numbers, int at) {
    double[] rows = new double[12];
    for (int i = 0; i < 12; i++) {
      rows[i] = numbers[at + i / COLUMNS + COLUMNS * (i % COLUMNS)];
    }
    return new GltfMatrix(rows);
  }

  /** Returns whether the last row of a 4×4 matrix is 0, 0, 0, 1. */
  static boolean isAffine(double[] columns) {
    return Math.abs(columns[3]) <= ROUNDING
        && Math.abs(columns[7]) <= ROUNDING
        && Math.abs(columns[11]) <= ROUNDING
        && Math.abs(columns[15] - 1) <= ROUNDING;
  }

  /**
   * Returns the map that scales, then rotates, then translates.
   *
   * @param rotation a unit quaternion: x, y, z, w
   */
  static GltfMatrix of(double[] translation, double[] rotation, double[] scale) {
    double x = rotation[0];
    double y = rotation[1];
    double z = rotation[2];
    double w = rotation[3];
    double sx = scale[0];
    double sy = scale[1];
    double sz = scale[2];
    return new GltfMatrix(
        sx * (1 - 2 * (y * y + z * z)),
        sy * 2 * (x * y - z * w),
        sz * 2 * (x * z + y * w),
        translation[0],
        sx * 2 * (x * y + z * w),
        sy * (1 - 2 * (x * x + z * z)),
        sz * 2 * (y * z - x * w),
        translation[1],
        sx * 2 * (x * z - y * w),
        sy * 2 * (y * z + x * w),
        sz * (1 - 2 * (x * x + y * y)),
        translation[2]);
  }

  /** Returns the map that applies another one first and then this. */
  GltfMatrix times(GltfMatrix inner) {
    double[] product = new double[12];
    for (int row = 0; row < 12; row += COLUMNS) {
      for (int column = 0; column < COLUMNS; column++) {
        product[row + column] =
            m[row] * inner.m[column]
                + m[row + 1] * inner.m[COLUMNS + column]
                + m[row + 2] * inner.m[2 * COLUMNS + column]
                + (column == 3 ? m[row + 3] : 0);
      }
    }
    return new GltfMatrix(product);
  }

  /** Returns whether this neither mirrors a solid nor flattens it. */
  boolean isPositive() {
    return dimensions() == 3 && column(0).cross(column(1)).dot(column(2)) > 0;
  }

  /**
   * Returns the rotation to the directions of the z-axis and, as far as it is perpendicular, of the
   * y-axis; other ones where these have no length.
   */
  GltfMatrix orientation() {
    Vec3 x = direction(column(0));
    Vec3 y = direction(column(1));
    Vec3 z = firstDirection(direction(column(2)), direction(x.cross(y)), Vec3.Z);
    Vec3 other = Math.abs(z.y()) < .9 ? Vec3.Y : Vec3.X;
    Vec3 up =
        firstDirection(
            perpendicular(y, z), direction(z.cross(perpendicular(x, z))), perpendicular(other, z));
    Vec3 right = up.cross(z);
    return new GltfMatrix(
        right.x(), up.x(), z.x(), 0, right.y(), up.y(), z.y(), 0, right.z(), up.z(), z.z(), 0);
  }

  /** Returns a vector with length 1; zero if it has no direction. */
  private static Vec3 direction(Vec3 vector) {
    double size = vector.maxAbs();
    return size > 0 && Double.isFinite(size) ? vector.normalized() : Vec3.ZERO;
  }

  /** Returns the direction of the part of a unit vector that is perpendicular to another one. */
  private static Vec3 perpendicular(Vec3 vector, Vec3 to) {
    Vec3 rest = vector.plus(-vector.dot(to), to);
    return rest.maxAbs() > THINNEST ? direction(rest) : Vec3.ZERO;
  }

  private static Vec3 firstDirection(Vec3... vectors) {
    return Arrays.stream(vectors).filter(v -> v.maxAbs() > 0).findFirst().orElseThrow();
  }

  /** Returns this map's translation after a map of directions. */
  GltfMatrix withAxesOf(GltfMatrix axes) {
    double[] rows = axes.m.clone();
    for (int i = 3; i < rows.length; i += COLUMNS) {
      rows[i] = m[i];
    }
    return new GltfMatrix(rows);
  }

  /** Returns whether all numbers are finite. */
  boolean isFinite() {
    return Arrays.stream(m).allMatch(Double::isFinite);
  }

  /** Returns the map; not invertible if this is singular. */
  Transform toTransform() {
    return Transform.ofAxes(column(0), column(1), column(2), column(3));
  }

  /**
   * Returns how many dimensions the image of a solid has, except for rounding: 3, 2 if it is
   * flattened to a plane, or 1 if it is a line or a point, or not finite.
   */
  int dimensions() {
    double size = Math.max(column(0).maxAbs(), Math.max(column(1).maxAbs(), column(2).maxAbs()));
    if (!(size > 0) || !isFinite()) {
      return 1;
    }
    Vec3 a = column(0).times(1 / size);
    Vec3 b = column(1).times(1 / size);
    Vec3 c = column(2).times(1 / size);
    Vec3 bc = b.cross(c);
    double area = Math.max(bc.maxAbs(), Math.max(c.cross(a).maxAbs(), a.cross(b).maxAbs()));
    if (!(area > NARROWEST)) {
      return 1;
    }
    return Math.abs(a.dot(bc)) > THINNEST * area * area ? 3 : 2;
  }

  private Vec3 column(int i) {
    return new Vec3(m[i], m[COLUMNS + i], m[2 * COLUMNS + i]);
  }

  /** Adds a multiple of this to twelve numbers: three rows of four. */
  void addTo(double[] sum, double factor) {
    for (int i = 0; i < 12; i++) {
      sum[i] += factor * m[i];
    }
  }
}
