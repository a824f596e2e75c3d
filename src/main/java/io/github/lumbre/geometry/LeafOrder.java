package io.github.lumbre.geometry;

/**
 * Numbers the items of a tree's leaves in the order of {@link #add}, separately for each kind.
 * Mutable.
 */
final class LeafOrder {
  private final int[] order;
  private final int[] triangles;
  private final int[] shapes;
  private int triangleCount;
  private int shapeCount;

  /**
   * Creates an order without leaves.
   *
   * @param order the builder's order of item numbers
   * @param triangles the number of triangles among the items
   */
  LeafOrder(int[] order, int triangles) {
    this.order = order;
    this.triangles = new int[triangles];
    shapes = new int[order.length - triangles];
  }

  /** Adds the items of a leaf; returns the {@link LeafRef} to their new position. */
  int add(BvhNode.Leaf leaf) {
    int count = leaf.end() - leaf.first();
    boolean ofShapes = order[leaf.first()] >= triangles.length;
    int first = ofShapes ? shapeCount : triangleCount;
    System.arraycopy(order, leaf.first(), ofShapes ? shapes : triangles, first, count);
    if (ofShapes) {
      shapeCount += count;
    } else {
      triangleCount += count;
    }
    return LeafRef.of(ofShapes, first, count);
  }

  /** Returns the item numbers of the triangles in leaf order. */
  int[] triangles() {
    return triangles;
  }

  /** Returns the item numbers of the shapes in leaf order. */
  int[] shapes() {
    return shapes;
  }
}
