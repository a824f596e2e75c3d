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

  private final BvhTree tree;

  /**
   * For each inner node, top down and left before right: how many of 2, 3, … places for its
   * descendants go to its left child. A share of 0 means that the node is kept and takes one place.
   */
  private final int[] shares;

  /** For each inner node, the number of its right child if that is an inner node. */
  private final int[] rights;

  /** The boxes of the inner nodes. */
  private final double[] boxes;

  private final Kept root;
  private int count;

  /** The children of the current node. */
  private final Kept[] lanes = new Kept[WIDTH];

  private int filled;

  /** For each depth, the results of {@link #weigh} for left and right children, and their boxes. */
  private final double[][] weights = new double[2 * (BvhBuilder.MAX_DEPTH + 1)][WIDTH + 1];

  private final double[][] childBoxes = new double[2 * (BvhBuilder.MAX_DEPTH + 1)][ItemBox.SIZE];

  WideCollapse(BvhTree tree) {
    this.tree = tree;
    int innerNodes = tree.innerNodes();
    shares = new int[innerNodes];
    rights = new int[innerNodes];
    boxes = new double[Math.multiplyExact(ItemBox.SIZE, innerNodes)];
    double[] box = new double[ItemBox.SIZE];
    weigh(tree.root(), 0, tree.count(), new double[WIDTH + 1], box, 0);
    root = new Kept(tree.root(), 0, 0, tree.count(), box);
  }

  /**
   * A kept node of the binary hierarchy, over items in [first, end).
   *
   * @param node see {@link BvhTree}
   * @param number of an inner node, as the arrays have it
   */
  record Kept(int node, int number, int first, int end, double[] box) {
    boolean isLeaf() {
      return node == BvhTree.LEAF;
    }
  }

  /** Returns the root, which is always kept. */
  Kept root() {
    return root;
  }

  /** Returns the children, at most eight, of a kept node; for a leaf, the leaf itself. */
  Kept[] children(Kept parent) {
    filled = 0;
    fill(parent.node(), parent.number(), parent.first(), parent.end(), WIDTH);
    return Arrays.copyOf(lanes, filled);
  }

  /** Stores a node in one lane, or its descendants in at most the given number of lanes. */
  private void fill(int node, int number, int first, int end, int places) {
    int share = node == BvhTree.LEAF ? 0 : shares[number] >>> BITS * (places - 1) & MASK;
    if (share == 0) {
      lanes[filled++] = new Kept(node, number, first, end, box(node, number, first, end));
      return;
    }
    fill(tree.left(node), number + 1, first, node, share);
    fill(tree.right(node), rights[number], node, end, places - share);
  }

  private double[] box(int node, int number, int first, int end) {
    double[] box = new double[ItemBox.SIZE];
    if (node == BvhTree.LEAF) {
      tree.copyBox(first, end, box);
    } else {
      System.arraycopy(boxes, ItemBox.SIZE * number, box, 0, ItemBox.SIZE);
    }
    return box;
  }

  /**
   * Numbers the inner nodes of a subtree over items in [first, end) and chooses their shares.
   *
   * @param least set at index n, from 1 on, to the least total surface of kept nodes if this node
   *     and its descendants have n places; index 0 is unused
   * @param box set to the box of the node
   * @param depth the depth of the node
   */
  private void weigh(int node, int first, int end, double[] least, double[] box, int depth) {
    if (node == BvhTree.LEAF) {
      Arrays.fill(least, 0);
      tree.copyBox(first, end, box);
      return;
    }
    int number = count++;
    double[] leftBox = childBoxes[2 * depth];
    double[] rightBox = childBoxes[2 * depth + 1];
    weigh(tree.left(node), first, node, weights[2 * depth], leftBox, depth + 1);
    rights[number] = count;
    weigh(tree.right(node), node, end, weights[2 * depth + 1], rightBox, depth + 1);
    ItemBox.storeUnion(leftBox, 0, rightBox, 0, box, 0);
    System.arraycopy(box, 0, boxes, ItemBox.SIZE * number, ItemBox.SIZE);
    shares[number] =
        shares(weights[2 * depth], weights[2 * depth + 1], ItemBox.halfArea(box), least);
  }

  /** Returns the shares of a node with a surface, given the results of its children. */
  private static int shares(double[] left, double[] right, double surface, double[] least) {
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
        least[1] = surface + sum;
      }
      if (least[1] < sum) {
        sum = least[1];
        best = 0;
      }
      least[places] = sum;
      chosen |= best << BITS * (places - 1);
    }
    return chosen;
  }
}
