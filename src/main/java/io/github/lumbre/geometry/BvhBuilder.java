package io.github.lumbre.geometry;

import java.util.Arrays;

/**
 * Builds a binary hierarchy over boxes, from the top down, by the binned surface area heuristic:
 * Wald 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies". Mutable, used once.
 *
 * <p>An item is known by its number. Those below {@code triangles} are triangles, the others are
 * shapes; a leaf holds one kind only.
 */
final class BvhBuilder {
  /** Deepest leaf; also the most entries that a traversal keeps on its stack. */
  static final int MAX_DEPTH = 96;

  /** Doubles a node: minimum and maximum on x, y, z of the first child's box, then the second's. */
  static final int NODE_SIZE = 12;

  /** Below this depth ranges are halved, which adds at most 31 levels, and a last one by kind. */
  private static final int MAX_SAH_DEPTH = 60;

  private static final int MAX_LEAF = 4;
  private static final int BINS = 16;

  /** The price of looking at a node's two boxes, in triangle tests. */
  private static final double NODE_COST = 1;

  private static final int COUNT_BITS = 4;

  /** In place of an index into the nodes: the root's own box is not stored. */
  private static final int NOWHERE = -1;

  private final double[] boxes;
  private final int triangles;
  private final int[] order;
  private double[] nodes = new double[NODE_SIZE];
  private int[] children = new int[2];
  private int nodeCount;
  private final int[] triangleOrder;
  private int triangleCount;
  private final int[] shapeOrder;
  private int shapeCount;
  private int root;

  // Scratch memory of one split: the box of a range and that of its centres, and bins by axis.
  private final double[] range = new double[6];
  private final double[] centres = new double[6];
  private final int[] binCount = new int[3 * BINS];
  private final double[] binBox = new double[3 * BINS * 6];
  private final double[] rightCost = new double[BINS];
  private int bins;

  /**
   * @param boxes six doubles an item: minimum and maximum on x, y, z; finite; will be reordered
   * @param triangles how many of the items, the first ones, are triangles
   */
  BvhBuilder(double[] boxes, int triangles) {
    this.boxes = boxes;
    this.triangles = triangles;
    int items = boxes.length / 6;
    if (items >= 1 << 30 - COUNT_BITS) {
      throw new IllegalArgumentException("items: expected at most 2^26 - 1, found " + items);
    }
    order = new int[items];
    for (int i = 0; i < items; i++) {
      order[i] = i;
    }
    triangleOrder = new int[triangles];
    shapeOrder = new int[items - triangles];
    if (items > 0) {
      root = build(0, items, 0, NOWHERE);
    }
    nodes = Arrays.copyOf(nodes, nodeCount * NODE_SIZE);
    children = Arrays.copyOf(children, nodeCount * 2);
  }

  /** Returns the boxes of the nodes' children, {@link #NODE_SIZE} doubles a node. */
  double[] nodes() {
    return nodes;
  }

  /** Returns two children a node: a node's number, or a negative number for a leaf. */
  int[] children() {
    return children;
  }

  /** Returns the child that holds all; meaningless if there are no items. */
  int root() {
    return root;
  }

  /** Returns the triangles' numbers in the order of the leaves. */
  int[] triangleOrder() {
    return triangleOrder;
  }

  /** Returns the shapes' item numbers in the order of the leaves. */
  int[] shapeOrder() {
    return shapeOrder;
  }

  private static int leaf(boolean ofShapes, int first, int count) {
    return ~((first << COUNT_BITS + 1) | (ofShapes ? 1 << COUNT_BITS : 0) | count);
  }

  static boolean isLeafOfShapes(int leaf) {
    return (~leaf >> COUNT_BITS & 1) != 0;
  }

  static int leafFirst(int leaf) {
    return ~leaf >>> COUNT_BITS + 1;
  }

  static int leafCount(int leaf) {
    return ~leaf & (1 << COUNT_BITS) - 1;
  }

  /**
   * Builds the subtree over a range of the order.
   *
   * @param at where in the nodes the range's box belongs
   */
  private int build(int first, int end, int depth, int at) {
    measure(first, end);
    if (at != NOWHERE) {
      System.arraycopy(range, 0, nodes, at, 6);
    }
    if (end - first == 1) {
      return makeLeaf(first, end);
    }
    int middle = depth < MAX_SAH_DEPTH ? splitBySurfaceArea(first, end) : first;
    if (middle == first && end - first <= MAX_LEAF) {
      int shapes = partitionKinds(first, end);
      if (shapes == first || shapes == end) {
        return makeLeaf(first, end);
      }
      middle = shapes;
    } else if (middle == first) {
      middle = (first + end) >>> 1;
    }
    return makeNode(first, middle, end, depth);
  }

  private int makeNode(int first, int middle, int end, int depth) {
    int node = nodeCount++;
    if (nodeCount * 2 > children.length) {
      nodes = Arrays.copyOf(nodes, nodes.length * 2);
      children = Arrays.copyOf(children, children.length * 2);
    }
    int left = build(first, middle, depth + 1, node * NODE_SIZE);
    int right = build(middle, end, depth + 1, node * NODE_SIZE + 6);
    children[2 * node] = left;
    children[2 * node + 1] = right;
    return node;
  }

  private int makeLeaf(int first, int end) {
    boolean ofShapes = order[first] >= triangles;
    int start = ofShapes ? shapeCount : triangleCount;
    for (int i = first; i < end; i++) {
      if (ofShapes) {
        shapeOrder[shapeCount++] = order[i];
      } else {
        triangleOrder[triangleCount++] = order[i];
      }
    }
    return leaf(ofShapes, start, end - first);
  }

  /** Sets the box of a range and the box of its centres. */
  private void measure(int first, int end) {
    clear(range, 0);
    clear(centres, 0);
    for (int i = first; i < end; i++) {
      grow(range, 0, boxes, 6 * i);
      for (int axis = 0; axis < 3; axis++) {
        double c = centre(i, axis);
        if (c < centres[2 * axis]) {
          centres[2 * axis] = c;
        }
        if (c > centres[2 * axis + 1]) {
          centres[2 * axis + 1] = c;
        }
      }
    }
  }

  /** Puts triangles before shapes; returns the first shape's place. */
  private int partitionKinds(int first, int end) {
    int middle = first;
    for (int i = first; i < end; i++) {
      if (order[i] < triangles) {
        swap(i, middle++);
      }
    }
    return middle;
  }

  /** Returns where the reordered range should be split, or first if it should not or cannot be. */
  private int splitBySurfaceArea(int first, int end) {
    int count = end - first;
    bins = Math.min(BINS, 2 * count);
    fillBins(first, end);
    double best =
        count <= MAX_LEAF ? halfArea(range, 0) * (count - NODE_COST) : Double.POSITIVE_INFINITY;
    int bestAxis = -1;
    int bestBin = 0;
    double[] left = new double[6];
    for (int axis = 0; axis < 3; axis++) {
      fillRightCosts(axis);
      clear(left, 0);
      int leftCount = 0;
      for (int bin = 0; bin < bins - 1; bin++) {
        if (binCount[BINS * axis + bin] == 0) {
          continue;
        }
        grow(left, 0, binBox, 6 * (BINS * axis + bin));
        leftCount += binCount[BINS * axis + bin];
        double cost = leftCount * halfArea(left, 0) + rightCost[bin + 1];
        if (leftCount < count && cost < best) {
          best = cost;
          bestAxis = axis;
          bestBin = bin;
        }
      }
    }
    return bestAxis < 0 ? first : partition(first, end, bestAxis, bestBin);
  }

  private void fillBins(int first, int end) {
    Arrays.fill(binCount, 0);
    for (int axis = 0; axis < 3; axis++) {
      for (int bin = 0; bin < bins; bin++) {
        clear(binBox, 6 * (BINS * axis + bin));
      }
      double low = centres[2 * axis];
      double scale = binScale(axis);
      for (int i = first; i < end; i++) {
        int bin = BINS * axis + bin(i, axis, low, scale);
        binCount[bin]++;
        grow(binBox, 6 * bin, boxes, 6 * i);
      }
    }
  }

  /** Sets, for each bin of an axis, the cost of a leaf made of it and all later ones. */
  private void fillRightCosts(int axis) {
    double[] right = new double[6];
    clear(right, 0);
    int count = 0;
    for (int bin = bins - 1; bin > 0; bin--) {
      if (binCount[BINS * axis + bin] > 0) {
        grow(right, 0, binBox, 6 * (BINS * axis + bin));
        count += binCount[BINS * axis + bin];
      }
      rightCost[bin] = count * halfArea(right, 0);
    }
  }

  private int partition(int first, int end, int axis, int lastLeft) {
    double low = centres[2 * axis];
    double scale = binScale(axis);
    int middle = first;
    for (int i = first; i < end; i++) {
      if (bin(i, axis, low, scale) <= lastLeft) {
        swap(i, middle++);
      }
    }
    return middle;
  }

  /** Returns bins a length; 0, which puts all into the first bin, if the centres coincide. */
  private double binScale(int axis) {
    double length = centres[2 * axis + 1] - centres[2 * axis];
    return length > 0 ? bins / length : 0;
  }

  private int bin(int i, int axis, double low, double scale) {
    return Math.min(bins - 1, (int) ((centre(i, axis) - low) * scale));
  }

  private double centre(int i, int axis) {
    return .5 * boxes[6 * i + 2 * axis] + .5 * boxes[6 * i + 2 * axis + 1];
  }

  private void swap(int i, int j) {
    int item = order[i];
    order[i] = order[j];
    order[j] = item;
    for (int k = 0; k < 6; k++) {
      double bound = boxes[6 * i + k];
      boxes[6 * i + k] = boxes[6 * j + k];
      boxes[6 * j + k] = bound;
    }
  }

  private static void clear(double[] box, int at) {
    for (int axis = 0; axis < 3; axis++) {
      box[at + 2 * axis] = Double.POSITIVE_INFINITY;
      box[at + 2 * axis + 1] = Double.NEGATIVE_INFINITY;
    }
  }

  private static void grow(double[] box, int at, double[] by, int byAt) {
    for (int axis = 0; axis < 6; axis += 2) {
      // Comparisons: almost always as the last time, and so faster here than Math.min.
      if (by[byAt + axis] < box[at + axis]) {
        box[at + axis] = by[byAt + axis];
      }
      if (by[byAt + axis + 1] > box[at + axis + 1]) {
        box[at + axis + 1] = by[byAt + axis + 1];
      }
    }
  }

  /** Returns half the surface of a box; of an empty one, 0. */
  private static double halfArea(double[] box, int at) {
    double x = box[at + 1] - box[at];
    double y = box[at + 3] - box[at + 2];
    double z = box[at + 5] - box[at + 4];
    return x >= 0 ? x * y + y * z + z * x : 0;
  }
}
