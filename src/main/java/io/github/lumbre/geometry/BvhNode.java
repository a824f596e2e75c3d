package io.github.lumbre.geometry;

/** A node of a hierarchy during its build; each traversal copies the nodes into its own arrays. */
sealed interface BvhNode {
  /** The empty box. */
  double[] EMPTY = {1 / 0.0, -1 / 0.0, 1 / 0.0, -1 / 0.0, 1 / 0.0, -1 / 0.0};

  /** Returns the minimum and maximum on x, y, z of all items below; callers must not modify it. */
  double[] box();

  /** The builder's items in [first, end) of its order: only triangles or only shapes. */
  record Leaf(double[] box, int first, int end) implements BvhNode {}

  /** An inner node with two children. */
  record Inner(double[] box, BvhNode left, BvhNode right) implements BvhNode {}
}
