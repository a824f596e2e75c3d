package io.github.lumbre.geometry;

/**
 * The encoding of a leaf as a negative number: the kind of its items, the position of the first
 * item among its kind, and the number of items.
 */
final class LeafRef {
  private static final int COUNT_BITS = 4;

  private LeafRef() {}

  /**
   * Returns the encoded leaf.
   *
   * @param first the position of the first item among its kind
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
