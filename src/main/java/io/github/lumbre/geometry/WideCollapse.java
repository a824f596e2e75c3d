package io.github.lumbre.geometry;

import java.util.Arrays;

/**
 * Collapses a binary hierarchy to one with up to eight children per node: it chooses the nodes to
 * keep. The choice minimizes their total surface area, to which the number of node visits per ray
 * is roughly proportional. Mutable; each instance collapses one tree.
 *
 * <p>It uses dynamic programming from the leaves up: Ylitie et al. 2017, "Efficient Incoherent Ray
 * Traversal on GPUs Through Compressed Wide BVHs", sec. 3.1. Leaves are not changed.
 */
final class WideCollapse {
  private static final int WIDTH = WideTree.WIDTH;

  /** The bits of one share. */
  private static final int BITS = 4;

  private static final int MASK = (1 << BITS) - 1;

  /**
   * For each inner node, top down and left before right: how many of 2, 3, … places for its
   * descendants go to its left child. A share of 0 means that the node is kept and takes one place.
   */
  private int[] shares = new int[1 << 10];

  /** For each inner node, the number of its right child if that is an inner node. */
  private int[] rights = new int[1 << 10];

  private int count;

  /** The children of the current node, and their numbers. */
  private final BvhNode[] lanes = new BvhNode[WIDTH];

  private final int[] numbers = new int[WIDTH];
  private int filled;

  WideCollapse(BvhNode tree) {
    weigh(tree);
  }

  /** A kept node of the binary hierarchy, and its number. */
  record Kept(BvhNode node, int number) {}

  /** Returns the root, which is always kept. */
  static Kept root(BvhNode tree) {
    return new Kept(tree, 0);
  }

  /** Returns the children, at most eight, of a kept node; for a leaf, the leaf itself. */
  Kept[] children(Kept parent) {
    filled = 0;
    fill(parent.node(), parent.number(), WIDTH);
    Kept[] children = new Kept[filled];
    Arrays.setAll(children, lane -> new Kept(lanes[lane], numbers[lane]));
    return children;
  }

  /** Stores a node in one lane, or its descendants in at most the given number of lanes. */
  private void fill(BvhNode node, int number, int places) {
    int share = node instanceof BvhNode.Inner ? shares[number] >>> BITS * (places - 1) & MASK : 0;
    if (share == 0) {
      lanes[filled] = node;
      numbers[filled++] = number;
      return;
    }
    BvhNode.Inner inner = (BvhNode.Inner) node;
    fill(inner.left(), number + 1, share);
    fill(inner.right(), rights[number], places - share);
  }

  /**
   * Numbers the inner nodes of a subtree and chooses their shares.
   *
   * @return at index n, from 1 on, the least total surface of kept nodes if this node and its
   *     descendants have n places; index 0 is unused
   */
  private double[] weigh(BvhNode node) {
    double[] least = new double[WIDTH + 1];
    if (!(node instanceof BvhNode.Inner inner)) {
      return least;
    }
    int number = count++;
    if (count > shares.length) {
      shares = Arrays.copyOf(shares, 2 * count);
      rights = Arrays.copyOf(rights, 2 * count);
    }
    double[] left = weigh(inner.left());
    rights[number] = count;
    double[] right = weigh(inner.right());
    int chosen = 0;
    for (int places = WIDTH; places > 1; places--) {
      int best = 1;
      for (int share = 2; share < places; share++) {
        if (left[share] + right[places - share] < left[best] + right[places - best]) {
          best = share;
        }
      }
      least[places] = left[best] + right[places - best];
      if (places == WIDTH) {
        least[1] = BvhSplitter.halfArea(node.box(), 0) + least[WIDTH];
      }
      if (least[1] < least[places]) {
        least[places] = least[1];
        best = 0;
      }
      chosen |= best << BITS * (places - 1);
    }
    shares[number] = chosen;
    return least;
  }
}
