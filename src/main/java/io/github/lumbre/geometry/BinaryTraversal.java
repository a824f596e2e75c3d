package io.github.lumbre.geometry;

import java.util.Arrays;

/**
 * The search that needs nothing but Java: one node with the boxes of its two children at a time, in
 * double precision.
 */
final class BinaryTraversal implements Traversal {
  static final LeafCost COSTS = new LeafCost(1, 4, 1);

  /** Doubles a node: minimum and maximum on x, y, z of the first child's box, then the second's. */
  private static final int NODE_SIZE = 12;

  private final int root;
  private final Triangles triangles;
  private final LeafShapes shapes;
  private final boolean hasTriangles;
  private double[] nodes = new double[NODE_SIZE];

  /** Two children a node: a node's number, or a {@link LeafRef}. */
  private int[] children = new int[2];

  private int nodeCount;

  BinaryTraversal(BvhNode tree, int[] order, BvhItems items) {
    LeafOrder leaves = new LeafOrder(order, items.triangleCount());
    root = store(tree, leaves);
    nodes = Arrays.copyOf(nodes, nodeCount * NODE_SIZE);
    children = Arrays.copyOf(children, nodeCount * 2);
    triangles = items.triangles(leaves.triangles());
    shapes = items.shapes(leaves.shapes());
    hasTriangles = leaves.triangles().length > 0;
  }

  private int store(BvhNode node, LeafOrder leaves) {
    if (node instanceof BvhNode.Leaf leaf) {
      return leaves.add(leaf);
    }
    BvhNode.Inner inner = (BvhNode.Inner) node;
    int number = nodeCount++;
    if (nodeCount * 2 > children.length) {
      nodes = Arrays.copyOf(nodes, nodes.length * 2);
      children = Arrays.copyOf(children, children.length * 2);
    }
    System.arraycopy(inner.left().box(), 0, nodes, number * NODE_SIZE, 6);
    System.arraycopy(inner.right().box(), 0, nodes, number * NODE_SIZE + 6, 6);
    int left = store(inner.left(), leaves);
    int right = store(inner.right(), leaves);
    children[2 * number] = left;
    children[2 * number + 1] = right;
    return number;
  }

  /** {@inheritDoc} All state of the loop is in local variables on purpose. */
  @Override
  public boolean traverse(
      double ox, double oy, double oz, double dx, double dy, double dz, NearestHit nearest) {
    double[] boxes = nodes;
    int[] stack = nearest.stack;
    int[] stackNear = nearest.stackNear;
    int bottom = nearest.stackTop;
    int top = bottom;
    // Choose each axis' near side by the direction's sign; -0 chooses as a negative number would.
    double ix = 1 / dx;
    double iy = 1 / dy;
    double iz = 1 / dz;
    int nearX = Axes.sign(dx);
    int nearY = 2 + Axes.sign(dy);
    int nearZ = 4 + Axes.sign(dz);
    int farX = nearX ^ 1;
    int farY = nearY ^ 1;
    int farZ = nearZ ^ 1;
    // Widen all boxes by the origin's rounding: shift the origin in for the one side and the other.
    double margin = BvhItems.MARGIN * Axes.largest(ox, oy, oz);
    double inX = ox + Math.copySign(margin, ix);
    double inY = oy + Math.copySign(margin, iy);
    double inZ = oz + Math.copySign(margin, iz);
    double outX = ox - Math.copySign(margin, ix);
    double outY = oy - Math.copySign(margin, iy);
    double outZ = oz - Math.copySign(margin, iz);
    ShearedRay sheared = nearest.wideRay();
    if (hasTriangles) {
      sheared.take(ox, oy, oz, dx, dy, dz);
      sheared.shear();
    }
    boolean found = false;
    int best = rank(nearest.t);
    int node = root;
    while (true) {
      if (node >= 0) {
        // Test both children. A NaN needs an origin on the widened border: any answer is right.
        int at = node * NODE_SIZE;
        int near0 =
            nearRank(
                (boxes[at + nearX] - inX) * ix,
                (boxes[at + nearY] - inY) * iy,
                (boxes[at + nearZ] - inZ) * iz);
        int far0 =
            farRank(
                (boxes[at + farX] - outX) * ix,
                (boxes[at + farY] - outY) * iy,
                (boxes[at + farZ] - outZ) * iz);
        at += 6;
        int near1 =
            nearRank(
                (boxes[at + nearX] - inX) * ix,
                (boxes[at + nearY] - inY) * iy,
                (boxes[at + nearZ] - inZ) * iz);
        int far1 =
            farRank(
                (boxes[at + farX] - outX) * ix,
                (boxes[at + farY] - outY) * iy,
                (boxes[at + farZ] - outZ) * iz);
        int child = 2 * node;
        if (near0 <= Math.min(far0, best)) {
          if (near1 > Math.min(far1, best)) {
            node = children[child];
            continue;
          }
          // Go on with the nearer one.
          int farther = near0 <= near1 ? 1 : 0;
          stackNear[top] = Math.max(near0, near1);
          stack[top++] = children[child + farther];
          node = children[child + 1 - farther];
          continue;
        }
        if (near1 <= Math.min(far1, best)) {
          node = children[child + 1];
          continue;
        }
      } else {
        nearest.stackTop = top;
        boolean hit =
            LeafRef.isOfShapes(node)
                ? shapes.intersect(node, nearest)
                : triangles.intersect(node, sheared, nearest);
        if (hit) {
          found = true;
          best = rank(nearest.t);
          if (nearest.any) {
            break;
          }
        }
      }
      // Take up the last node put aside that does not begin beyond the best hit.
      do {
        top--;
      } while (top >= bottom && stackNear[top] > best);
      if (top < bottom) {
        break;
      }
      node = stack[top];
    }
    nearest.stackTop = bottom;
    return found;
  }

  /**
   * Returns the upper half of a number's bits. It never falls as the number rises, and all negative
   * numbers have negative ranks; among those the order is lost, but slabs only compare with what is
   * not negative. Ranks make the search insensitive to order beyond a millionth, never wrong; and
   * the smaller of two integers costs a fraction of that of two doubles, which minds NaN and -0.
   */
  private static int rank(double t) {
    return (int) (Double.doubleToRawLongBits(t) >> 32);
  }

  /** Returns the rank of where a ray is inside all three slabs, and at t ≥ 0. */
  private static int nearRank(double x, double y, double z) {
    return Math.max(Math.max(rank(x), rank(y)), Math.max(rank(z), 0));
  }

  /** Returns the rank of where a ray leaves the first of three slabs. */
  private static int farRank(double x, double y, double z) {
    return Math.min(Math.min(rank(x), rank(y)), rank(z));
  }
}
