package io.github.lumbre.geometry;

/**
 * The costs of a traversal for the surface area heuristic. The unit is the test of one shape or of
 * one block of triangles.
 *
 * @param block the number of triangles tested at once; a power of two
 * @param maxUnits the maximum cost of a leaf, in units
 * @param nodeCost the cost of testing the boxes of a binary node's children, in units
 * @param isWide whether nodes with many children are made of several binary ones
 */
record LeafCost(int block, int maxUnits, double nodeCost, boolean isWide) {
  /** The cost of a leaf, in units, beyond which a range is large. */
  private static final int LARGE = 64;

  /** The maximum number of large triangles in a leaf: a rectangle has two. */
  private static final int MAX_LARGE = 2;

  /**
   * Returns the costs of the large items that {@link BuildItems#partitionLarge} separates. The
   * surface area heuristic assumes that rays come from outside, and so pass a room's walls twice.
   * But most start inside and end at the first wall, so that each wall pays as a leaf of its own.
   */
  LeafCost ofLarge() {
    return new LeafCost(MAX_LARGE, 1, nodeCost, isWide);
  }

  /** Returns the weight of one item; {@link #units} takes the sum of the weights. */
  int weight(boolean isTriangle) {
    return isTriangle ? 1 : block;
  }

  /** Returns the cost, in units, of a leaf whose items have the given total weight. */
  int units(int weight) {
    return (weight + block - 1) / block;
  }

  /**
   * Returns the cost of a part of a split range, relative to other parts. The surface area
   * heuristic takes the cost of a leaf, as if the part were not split again. In large ranges, this
   * overestimates meshes so much that other shapes are split badly. Measured: rays visit fewer wide
   * nodes there if the cost grows with the square root.
   *
   * @param weight the total weight of the part's items
   * @param whole the total weight of the range's items
   */
  double partCost(int weight, int whole) {
    return isWide && units(whole) > LARGE ? Math.sqrt(units(weight)) : units(weight);
  }
}
