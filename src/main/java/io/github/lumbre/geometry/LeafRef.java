package io.github.lumbre.geometry;

/**
 * Leaves as the searches store them: a negative number that tells the kind of the items, the first
 * one's place among its kind, and their count.
 */
final class LeafRef {
  private static final int COUNT_BITS = 4;

  private LeafRef() {}

  /**
   * @param count 1 to 15
   */
  static int of(boolean ofShapes, int first, int count) {
    return ~((first << COUNT_BITS + 1) | (ofShapes ? 1 << COUNT_BITS : 0) | count);
  }

  static boolean isOfShapes(int leaf) {
    return (~leaf >> COUNT_BITS & 1) != 0;
  }

  static int first(int leaf) {
    return ~leaf >>> COUNT_BITS + 1;
  }

  static int count(int leaf) {
    return ~leaf & (1 << COUNT_BITS) - 1;
  }
}
