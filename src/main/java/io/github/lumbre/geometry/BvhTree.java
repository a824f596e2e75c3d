package io.github.lumbre.geometry;

/**
 * A binary hierarchy over items: it orders them, and divides ranges of that order. Immutable. A few
 * integers for each item, instead of objects, make it small and quickly built.
 *
 * <p>A node is the range of items below it. An inner node is the position at which its range is
 * divided, from 1 on, which no other node has. A leaf is {@link #LEAF}; it has only triangles or
 * only shapes.
 */
final class BvhTree {
  /** Every leaf. */
  static final int LEAF = 0;

  private final BvhItems items;
  private final int[] order;
  private final int[] children;
  private final int root;

  /**
   * Creates a tree.
   *
   * @param order the numbers of all items
   * @param children the two children of the inner node p at 2p and 2p + 1; 0 where there is none
   * @param root an inner node or {@link #LEAF}
   */
  BvhTree(BvhItems items, int[] order, int[] children, int root) {
    this.items = items;
    this.order = order;
    this.children = children;
    this.root = root;
  }

  /** Returns the item numbers in leaf order; callers must not modify them. */
  int[] order() {
    return order;
  }

  /** Returns the number of items. */
  int count() {
    return order.length;
  }

  /** Returns the node over all items. */
  int root() {
    return root;
  }

  /** Returns the first half of an inner node, whose range ends where the node is divided. */
  int left(int inner) {
    return children[2 * inner];
  }

  /** Returns the second half of an inner node. */
  int right(int inner) {
    return children[2 * inner + 1];
  }

  int innerNodes() {
    int found = root == LEAF ? 0 : 1;
    for (int child : children) {
      found += child == LEAF ? 0 : 1;
    }
    return found;
  }

  /** Stores the box of a range of items. */
  void copyBox(int first, int end, double[] target) {
    items.copyBox(order[first], target);
    if (end - first > 1) {
      double[] box = new double[ItemBox.SIZE];
      for (int i = first + 1; i < end; i++) {
        items.copyBox(order[i], box);
        ItemBox.grow(target, box);
      }
    }
  }
}
