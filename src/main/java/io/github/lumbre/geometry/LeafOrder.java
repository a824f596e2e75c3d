package io.github.lumbre.geometry;

import io.github.lumbre.geometry.internal.HierarchyLimitException;
import java.util.Arrays;

/**
 * Numbers the items of a tree's leaves, separately for each kind: in the order of {@link #add}, or
 * triangles so that no leaf is in two blocks. Mutable.
 */
final class LeafOrder {
  private final int[] order;
  private final int triangleItems;
  private final int[] shapes;
  private int[] triangles;
  private int triangleCount;
  private int shapeCount;

  /** The number of places in a block; 0 if there are no blocks. */
  private final int block;

  /** The largest number of a place that a leaf can start at. */
  private final int lastPlace;

  /** For a number of free places, the first of them in the latest block that has so many, or -1. */
  private final int[] free;

  /**
   * Creates an order without leaves and without blocks.
   *
   * @param order the builder's order of item numbers
   * @param triangles the number of triangles among the items
   */
  LeafOrder(int[] order, int triangles) {
    this(order, triangles, 0, BvhBuilder.MAX_ITEMS);
  }

  /**
   * Creates an order without leaves, with blocks of triangles.
   *
   * @param block the number of places in a block
   * @param lastPlace the largest number of a place that a leaf can start at
   */
  LeafOrder(int[] order, int triangles, int block, int lastPlace) {
    this.order = order;
    this.block = block;
    this.lastPlace = lastPlace;
    triangleItems = triangles;
    this.triangles = new int[triangles];
    shapes = new int[order.length - triangles];
    free = new int[block + 1];
    Arrays.fill(free, -1);
  }

  /**
   * Adds the items of a leaf, a range of the builder's order; returns the {@link LeafRef} to their
   * new position.
   *
   * @throws HierarchyLimitException if there is no place for them
   */
  int add(int first, int end) {
    int count = end - first;
    boolean ofShapes = order[first] >= triangleItems;
    int place = ofShapes ? shapeCount : place(count);
    System.arraycopy(order, first, ofShapes ? shapes : triangles, place, count);
    if (ofShapes) {
      shapeCount += count;
    }
    return LeafRef.of(ofShapes, place, count);
  }

  /** Returns the first of so many places for triangles, in the fullest block that has them. */
  private int place(int count) {
    int room = count;
    while (room < block && free[room] < 0) {
      room++;
    }
    if (room < block) {
      int first = free[room];
      free[room] = -1;
      free[room - count] = first + count;
      return first;
    }
    int first = triangleCount;
    if (first > lastPlace) {
      throw new HierarchyLimitException(
          "the vector kernel has no place for so many triangles; expected at most about 63 million,"
              + " or the scalar kernel");
    }
    triangleCount += Math.max(count, block);
    free[Math.max(0, block - count)] = first + count;
    if (triangleCount > triangles.length) {
      triangles = Arrays.copyOf(triangles, triangleCount + triangleCount / 8);
    }
    return first;
  }

  /** Returns the item numbers of the triangles in leaf order; places that no leaf has are 0. */
  int[] triangles() {
    return triangles.length == triangleCount ? triangles : Arrays.copyOf(triangles, triangleCount);
  }

  /** Returns the item numbers of the shapes in leaf order. */
  int[] shapes() {
    return shapes;
  }
}
