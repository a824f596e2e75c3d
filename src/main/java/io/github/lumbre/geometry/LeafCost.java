package io.github.lumbre.geometry;

/**
 * What the surface area heuristic is to know of a search: how much it costs to test the items of a
 * leaf. A test of one shape, or of a block of triangles, is the unit.
 *
 * @param block how many triangles are tested at once; a power of two
 * @param maxUnits the most units in a leaf
 * @param nodeCost the cost of looking at the boxes of a binary node's children, in the same unit
 */
record LeafCost(int block, int maxUnits, double nodeCost) {
  /** Returns the share of one item, to be added up for {@link #units}. */
  int weight(boolean isTriangle) {
    return isTriangle ? 1 : block;
  }

  /** Returns the units of a leaf whose items have so much weight together. */
  int units(int weight) {
    return (weight + block - 1) / block;
  }
}
