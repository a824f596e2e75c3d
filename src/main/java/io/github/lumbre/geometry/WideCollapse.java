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

  /** For each depth, the results of {@link #weigh} for a left and a right child. */
  private final double[][] weights = new double[2 * (BvhBuilder.MAX_DEPTH + 1)][WIDTH + 1];

  WideCollapse(BvhNode tree) {
    weigh(tree, new double[WIDTH + 1], 0);
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
    for (int lane = 0; lane < filled; lane++) {
      children[lane] = new Kept(lanes[lane], numbers[lane]);
    }
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
   * @param least set at index n, from 1 on, to the least total surface of kept nodes if this node
   *     and its descendants have n places; index 0 is unused
   * @param depth the depth of the node
   */
  private void weigh(BvhNode node, double[] least, int depth) {
    if (!(node instanceof BvhNode.Inner inner)) {
      Arrays.fill(least, 0);
      return;
    }
    int number = count++;
    if (count > shares.length) {
      shares = Arrays.copyOf(shares, 2 * count);
      rights = Arrays.copyOf(rights, 2 * count);
    }
    double[] left = weights[2 * depth];
    double[] right = weights[2 * depth + 1];
    weigh(inner.left(), left, depth + 1);
    rights[number] = count;
    weigh(inner.right(), right, depth + 1);
    int chosen = 0;
    for (int places = WIDTH; places > 1; places--) {
      int best = 1;
      double sum = left[1] + right[places - 1];
      for (int share = 2; share < places; share++) {
        double other = left[share] + right[places - share];
        if (other < sum) {
          sum = other;
          best = share;
        }
      }
      if (places == WIDTH) {
        least[1] = BvhNode.halfArea(node.box()) + sum;
      }
      if (least[1] < sum) {
        sum = least[1];
        best = 0;
      }
      least[places] = sum;
      chosen |= best << BITS * (places - 1);
    }
    shares[number] = chosen;
  }
}
