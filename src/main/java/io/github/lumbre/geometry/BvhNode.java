package io.github.lumbre.geometry;

/** A node of a hierarchy during its build; each traversal copies the nodes into its own arrays. */
sealed interface BvhNode {
  double[] EMPTY = {1 / 0.0, -1 / 0.0, 1 / 0.0, -1 / 0.0, 1 / 0.0, -1 / 0.0};

  /** Returns the minimum and maximum on x, y, z of all items below; callers must not modify it. */
  double[] box();

  /** Returns the number of inner nodes of the subtree. */
  int innerNodes();

  /** The builder's items in [first, end) of its order: only triangles or only shapes. */
  record Leaf(double[] box, int first, int end) implements BvhNode {
    @Override
    public int innerNodes() {
      return 0;
    }
  }

  /**
   * An inner node with two children.
   *
   * @param innerNodes the number of inner nodes of its subtree, with itself
   */
  record Inner(double[] box, BvhNode left, BvhNode right, int innerNodes) implements BvhNode {
    /** Creates a node with the smallest box around its children. */
    Inner(BvhNode left, BvhNode right) {
      this(union(left.box(), right.box()), left, right);
    }

    /** Creates a node with the given box. */
    Inner(double[] box, BvhNode left, BvhNode right) {
      this(box, left, right, 1 + left.innerNodes() + right.innerNodes());
    }
  }

  /** Returns the smallest box around two boxes. */
  static double[] union(double[] a, double[] b) {
    return new double[] {
      Math.min(a[0], b[0]),
      Math.max(a[1], b[1]),
      Math.min(a[2], b[2]),
      Math.max(a[3], b[3]),
      Math.min(a[4], b[4]),
      Math.max(a[5], b[5])
    };
  }

  /** Grows a box so that it contains another one. */
  static void grow(double[] box, double[] by) {
    for (int k = 0; k < 6; k += 2) {
      box[k] = Math.min(box[k], by[k]);
      box[k + 1] = Math.max(box[k + 1], by[k + 1]);
    }
  }

  /** Returns half the surface area of a box; 0 for an empty box. */
  static double halfArea(double[] box) {
    double x = box[1] - box[0];
    double y = box[3] - box[2];
    double z = box[5] - box[4];
    return x >= 0 ? x * y + y * z + z * x : 0;
  }
}
