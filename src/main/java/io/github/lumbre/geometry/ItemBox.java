package io.github.lumbre.geometry;

/**
 * Functions of boxes around items of a hierarchy: six doubles, the minimum and maximum on x, y, z.
 */
final class ItemBox {
  /** The number of doubles of a box. */
  static final int SIZE = 6;

  private static final double[] EMPTY = {1 / 0.0, -1 / 0.0, 1 / 0.0, -1 / 0.0, 1 / 0.0, -1 / 0.0};

  private ItemBox() {}

  /** Returns a new box without a point. */
  static double[] empty() {
    return EMPTY.clone();
  }

  /** Grows a box so that it contains another one. */
  static void grow(double[] box, double[] by) {
    for (int k = 0; k < SIZE; k += 2) {
      box[k] = Math.min(box[k], by[k]);
      box[k + 1] = Math.max(box[k + 1], by[k + 1]);
    }
  }

  /** Stores the smallest box around two boxes. */
  static void storeUnion(double[] a, int atA, double[] b, int atB, double[] target, int at) {
    for (int k = 0; k < SIZE; k += 2) {
      target[at + k] = Math.min(a[atA + k], b[atB + k]);
      target[at + k + 1] = Math.max(a[atA + k + 1], b[atB + k + 1]);
    }
  }

  /** Returns half the surface area of a box; 0 for an empty box. */
  static double halfArea(double[] box) {
    double x = box[1] - box[0];
    double y = box[3] - box[2];
    double z = box[5] - box[4];
    return x >= 0 ? x * y + y * z + z * x : 0;
  }
}
