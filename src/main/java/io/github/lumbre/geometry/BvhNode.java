package io.github.lumbre.geometry;

/** A node of a hierarchy while it is built; the searches lay it out in arrays of their own. */
sealed interface BvhNode {
  /** A box that holds nothing. */
  double[] EMPTY = {1 / 0.0, -1 / 0.0, 1 / 0.0, -1 / 0.0, 1 / 0.0, -1 / 0.0};

  /** Returns minimum and maximum on x, y, z of all below; not to be changed. */
  double[] box();

  /** The builder's items from first to before end in its order: triangles only or shapes only. */
  record Leaf(double[] box, int first, int end) implements BvhNode {}

  /** Two nodes. */
  record Inner(double[] box, BvhNode left, BvhNode right) implements BvhNode {}
}
