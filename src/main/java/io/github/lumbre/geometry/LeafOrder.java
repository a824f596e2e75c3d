package io.github.lumbre.geometry;

/** Numbers the items of a tree's leaves, each kind by itself, as the leaves are met. Mutable. */
final class LeafOrder {
  private final int[] order;
  private final int[] triangles;
  private final int[] shapes;
  private int triangleCount;
  private int shapeCount;

  /**
   * @param order the builder's
   * @param triangles how many of the items are triangles
   */
  LeafOrder(int[] order, int triangles) {
    this.order = order;
    this.triangles = new int[triangles];
    shapes = new int[order.length - triangles];
  }

  /** Takes a leaf's items; returns the {@link LeafRef} to where they are now. */
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

  /** Returns the triangles' item numbers in the order of the leaves. */
  int[] triangles() {
    return triangles;
  }

  /** Returns the shapes' item numbers in the order of the leaves. */
  int[] shapes() {
    return shapes;
  }
}
