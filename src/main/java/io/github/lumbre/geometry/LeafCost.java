package io.github.lumbre.geometry;

/**
 * The costs of a traversal for the surface area heuristic. The unit is the test of one shape or of
 * one block of triangles.
 *
 * @param block the number of triangles tested at once; a power of two
 * @param maxUnits the maximum cost of a leaf, in units
 * @param nodeCost the cost of testing the boxes of a binary node's children, in units
 */
record LeafCost(int block, int maxUnits, double nodeCost) {
  /** Returns the weight of one item; {@link #units} takes the sum of the weights. */
  int weight(boolean isTriangle) {
    return isTriangle ? 1 : block;
  }

  /** Returns the cost, in units, of a leaf whose items have the given total weight. */
  int units(int weight) {
    return (weight + block - 1) / block;
  }
}
