package io.github.lumbre.geometry;

import java.util.Optional;
import java.util.concurrent.atomic.LongAdder;

/**
 * The traversal of {@link BinaryTraversal} with a counter of visited nodes, leaves included. It is
 * slow and serves diagnostics only.
 */
final class CountingTraversal implements Traversal {
  private final Node root;
  private final Triangles triangles;
  private final LeafShapes shapes;
  private final LongAdder visits;

  /** A node with two children, or a leaf if they are absent. */
  private record Node(double[] box, Optional<Children> children, int leaf) {}

  private record Children(Node left, Node right) {}

  CountingTraversal(BvhTree tree, BvhItems items, LongAdder visits) {
    LeafOrder leaves = new LeafOrder(tree.order(), items.triangleCount());
    root = copy(tree, tree.root(), 0, tree.count(), leaves);
    triangles = items.triangles(leaves.triangles());
    shapes = items.shapes(leaves.shapes());
    this.visits = visits;
  }

  private static Node copy(BvhTree tree, int node, int first, int end, LeafOrder leaves) {
    double[] box = new double[ItemBox.SIZE];
    tree.copyBox(first, end, box);
    if (node == BvhTree.LEAF) {
      return new Node(box, Optional.empty(), leaves.add(first, end));
    }
    Node left = copy(tree, tree.left(node), first, node, leaves);
    Node right = copy(tree, tree.right(node), node, end, leaves);
    return new Node(box, Optional.of(new Children(left, right)), 0);
  }

  @Override
  public boolean traverse(
      double ox, double oy, double oz, double dx, double dy, double dz, NearestHit nearest) {
    return new Search(new double[] {ox, oy, oz}, new double[] {dx, dy, dz}, nearest).visit(root);
  }

  /** The traversal of one ray. */
  private final class Search {
    private final double[] origin;
    private final double[] direction;
    private final NearestHit nearest;
    private final double margin;
    private final ShearedRay sheared = new ShearedRay();

    Search(double[] origin, double[] direction, NearestHit nearest) {
      this.origin = origin;
      this.direction = direction;
      this.nearest = nearest;
      margin = BvhItems.MARGIN * Axes.largest(origin[0], origin[1], origin[2]);
      sheared.take(origin[0], origin[1], origin[2], direction[0], direction[1], direction[2]);
      sheared.shear();
    }

    /** Returns whether a hit below the node was found and stored. */
    boolean visit(Node node) {
      visits.increment();
      if (node.children.isEmpty()) {
        return test(node.leaf);
      }
      Node near = node.children.get().left;
      Node far = node.children.get().right;
      if (!(entry(near.box) <= entry(far.box))) {
        near = node.children.get().right;
        far = node.children.get().left;
      }
      boolean found = entry(near.box) <= nearest.t && visit(near);
      if (found && nearest.any) {
        return true;
      }
      return entry(far.box) <= nearest.t && visit(far) || found;
    }

    /**
     * Returns the t at which the ray enters a box, at least the t of the hit that it has passed;
     * NaN if it misses the box or has left it before.
     */
    private double entry(double[] box) {
      double in = nearest.passed.t;
      double out = Double.POSITIVE_INFINITY;
      for (int axis = 0; axis < 3; axis++) {
        double low = (box[2 * axis] - margin - origin[axis]) / direction[axis];
        double high = (box[2 * axis + 1] + margin - origin[axis]) / direction[axis];
        // NaN occurs for a ray that runs along the border of a slab, which counts as inside.
        in = low == low && high == high ? Math.max(in, Math.min(low, high)) : in;
        out = low == low && high == high ? Math.min(out, Math.max(low, high)) : out;
      }
      return in <= out ? in : Double.NaN;
    }

    private boolean test(int leaf) {
      if (LeafRef.isOfShapes(leaf)) {
        return shapes.intersect(leaf, nearest);
      }
      return triangles.intersect(leaf, sheared, nearest);
    }
  }
}
