package io.github.lumbre.geometry;

import java.util.Arrays;

/**
 * Chooses which nodes of a binary hierarchy become nodes of one with up to eight children each, and
 * which are left out: so that the nodes kept have the least surface together, to which the number
 * of those that a ray visits is about in proportion. Mutable, used once.
 *
 * <p>Dynamic programming from the leaves up: Ylitie et al. 2017, "Efficient Incoherent Ray
 * Traversal on GPUs Through Compressed Wide BVHs", sec. 3.1. Leaves are kept as they are.
 */
final class WideCollapse {
  private static final int WIDTH = WideTree.WIDTH;

  /** Bits of a share. */
  private static final int BITS = 4;

  private static final int MASK = (1 << BITS) - 1;

  /**
   * For each inner node, from the top down and left before right: how many of 2 places for its
   * descendants, of 3, and so on go to its left child; 0 if it is better kept as one.
   */
  private int[] shares = new int[1 << 10];

  /** For each inner node the number of its right child, if that is an inner node. */
  private int[] rights = new int[1 << 10];

  private int count;

  /** Memory for the children of one node, and for their numbers. */
  private final BvhNode[] lanes = new BvhNode[WIDTH];

  private final int[] numbers = new int[WIDTH];
  private int filled;

  WideCollapse(BvhNode tree) {
    weigh(tree);
  }

  /** A node of the binary hierarchy that is kept, and its number. */
  record Kept(BvhNode node, int number) {}

  /** Returns the root, which is kept. */
  static Kept root(BvhNode tree) {
    return new Kept(tree, 0);
  }

  /** Returns the children, at most eight, of a node that is kept; of a leaf, itself. */
  Kept[] children(Kept parent) {
    filled = 0;
    fill(parent.node(), parent.number(), WIDTH);
    Kept[] children = new Kept[filled];
    Arrays.setAll(children, lane -> new Kept(lanes[lane], numbers[lane]));
    return children;
  }

  /** Puts a node into a lane, or its descendants into as many as there are places. */
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
   * Numbers the inner nodes from one on down, and chooses their shares.
   *
   * @return the least surface of the nodes kept, if 1, 2, ... places are there for this one and its
   *     descendants; nothing at 0
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
