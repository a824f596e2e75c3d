package io.github.lumbre.geometry;

/**
 * The traversal in plain Java: it visits one node at a time and tests the boxes of its two children
 * in double precision.
 */
final class BinaryTraversal implements Traversal {
  static final LeafCost COSTS = new LeafCost(1, 4, 1, false);

  /**
   * Doubles per node: minimum and maximum on x, y, z of the first child's box, then the second's.
   */
  private static final int NODE_SIZE = 12;

  private final int root;
  private final Triangles triangles;
  private final LeafShapes shapes;
  private final boolean hasTriangles;
  private final double[] nodes;

  /** Two children per node: the number of a node, or a {@link LeafRef}. */
  private final int[] children;

  private int nodeCount;

  BinaryTraversal(BvhTree tree, BvhItems items) {
    int innerNodes = tree.innerNodes();
    nodes = new double[Math.multiplyExact(innerNodes, NODE_SIZE)];
    children = new int[2 * innerNodes];
    LeafOrder leaves = new LeafOrder(tree.order(), items.triangleCount());
    root = new Storing(tree, leaves).store(tree.root(), 0, tree.count(), new double[6], 0);
    triangles = items.triangles(leaves.triangles());
    shapes = items.shapes(leaves.shapes());
    hasTriangles = leaves.triangles().length > 0;
  }

  /** Stores the nodes of a tree, a node before its children and the left child first. */
  private final class Storing {
    private final BvhTree tree;
    private final LeafOrder leaves;
    private final double[] leafBox = new double[6];

    Storing(BvhTree tree, LeafOrder leaves) {
      this.tree = tree;
      this.leaves = leaves;
    }

    /**
     * Stores a node over items in [first, end), and its box at an offset of an array; returns its
     * number or a {@link LeafRef}.
     */
    int store(int node, int first, int end, double[] target, int at) {
      if (node == BvhTree.LEAF) {
        tree.copyBox(first, end, leafBox);
        System.arraycopy(leafBox, 0, target, at, 6);
        return leaves.add(first, end);
      }
      int number = nodeCount++;
      int boxes = number * NODE_SIZE;
      int left = store(tree.left(node), first, node, nodes, boxes);
      int right = store(tree.right(node), node, end, nodes, boxes + 6);
      ItemBox.storeUnion(nodes, boxes, nodes, boxes + 6, target, at);
      children[2 * number] = left;
      children[2 * number + 1] = right;
      return number;
    }
  }

  /**
   * {@inheritDoc} The loop keeps its state in local variables, so that the JIT can use registers.
   */
  @Override
  public boolean traverse(
      double ox, double oy, double oz, double dx, double dy, double dz, NearestHit nearest) {
    double[] boxes = nodes;
    int[] stack = nearest.stack;
    int[] stackNear = nearest.stackNear;
    int bottom = nearest.stackTop;
    int top = bottom;
    // The direction's sign selects the near side of each axis; -0 counts as negative.
    double ix = 1 / dx;
    double iy = 1 / dy;
    double iz = 1 / dz;
    int nearX = Axes.sign(dx);
    int nearY = 2 + Axes.sign(dy);
    int nearZ = 4 + Axes.sign(dz);
    int farX = nearX ^ 1;
    int farY = nearY ^ 1;
    int farZ = nearZ ^ 1;
    // Widen all boxes by the rounding of the origin: shift the origin one way for near sides and
    // the other way for far sides.
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
    int passed = rank(nearest.passed.t);
    int node = root;
    while (true) {
      if (node >= 0) {
        // Test both children. NaN occurs only for origins on the widened border, where either
        // result is correct.
        int at = node * NODE_SIZE;
        int near0 =
            nearRank(
                (boxes[at + nearX] - inX) * ix,
                (boxes[at + nearY] - inY) * iy,
                (boxes[at + nearZ] - inZ) * iz,
                passed);
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
                (boxes[at + nearZ] - inZ) * iz,
                passed);
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
          // Visit the nearer child first.
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
      // Pop the last node that the ray does not enter beyond the best hit. The test comes first:
      // with a loop that always runs once, the JIT bets that the stack is never empty, and has to
      // compile this method again.
      while (top > bottom && stackNear[top - 1] > best) {
        top--;
      }
      if (top == bottom) {
        break;
      }
      node = stack[--top];
    }
    nearest.stackTop = bottom;
    return found;
  }

  /**
   * Returns the upper half of the bits of a number. For numbers ≥ 0 it never decreases as the
   * number grows. Negative numbers have negative ranks in no useful order, but slabs are only
   * compared with ranks ≥ 0. Ranks order nodes to a relative precision of about 1e-6, which never
   * loses a hit. The minimum of two integers is much cheaper than the minimum of two doubles, which
   * must handle NaN and -0.
   */
  private static int rank(double t) {
    return (int) (Double.doubleToRawLongBits(t) >> 32);
  }

  /** Returns the rank of the t, at least {@code least}, from which a ray is inside three slabs. */
  private static int nearRank(double x, double y, double z, int least) {
    return Math.max(Math.max(rank(x), rank(y)), Math.max(rank(z), least));
  }

  /** Returns the rank of the t at which a ray first leaves one of three slabs. */
  private static int farRank(double x, double y, double z) {
    return Math.min(Math.min(rank(x), rank(y)), rank(z));
  }
}
