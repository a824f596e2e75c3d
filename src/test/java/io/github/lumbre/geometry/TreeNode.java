package io.github.lumbre.geometry;

/** A node of a {@link BvhTree} as an object, with its box. */
sealed interface TreeNode {
  double[] box();

  record Leaf(double[] box, int first, int end) implements TreeNode {}

  record Inner(double[] box, TreeNode left, TreeNode right) implements TreeNode {}

  static TreeNode of(BvhTree tree) {
    return of(tree, tree.root(), 0, tree.count());
  }

  private static TreeNode of(BvhTree tree, int node, int first, int end) {
    double[] box = new double[6];
    tree.copyBox(first, end, box);
    return node == BvhTree.LEAF
        ? new Leaf(box, first, end)
        : new Inner(
            box,
            of(tree, tree.left(node), first, node),
            of(tree, tree.right(node), node, end));
  }
}
