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

  // Scratch memory of one split.
  private final int[] binCount = new int[BINS];
  private final double[] binBox = new double[6 * BINS];
  private final double[] rightCost = new double[BINS];

  /**
   * @param boxes six doubles an item: minimum and maximum on x, y, z; finite
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
      root = build(0, items, 0);
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

  private int build(int first, int end, int depth) {
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
    storeBox(first, middle, node * NODE_SIZE);
    storeBox(middle, end, node * NODE_SIZE + 6);
    int left = build(first, middle, depth + 1);
    int right = build(middle, end, depth + 1);
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

  private void storeBox(int first, int end, int at) {
    clear(nodes, at);
    for (int i = first; i < end; i++) {
      grow(nodes, at, boxes, 6 * order[i]);
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
    double[] all = new double[6];
    clear(all, 0);
    double[] centres = new double[6];
    clear(centres, 0);
    for (int i = first; i < end; i++) {
      grow(all, 0, boxes, 6 * order[i]);
      for (int axis = 0; axis < 3; axis++) {
        double c = centre(order[i], axis);
        centres[2 * axis] = Math.min(centres[2 * axis], c);
        centres[2 * axis + 1] = Math.max(centres[2 * axis + 1], c);
      }
    }
    double area = halfArea(all, 0);
    int count = end - first;
    double best = count <= MAX_LEAF ? area * count - area * NODE_COST : Double.POSITIVE_INFINITY;
    int bestAxis = -1;
    int bestBin = 0;
    for (int axis = 0; axis < 3; axis++) {
      double low = centres[2 * axis];
      double scale = BINS / (centres[2 * axis + 1] - low);
      if (!(centres[2 * axis + 1] > low)) {
        continue;
      }
      fillBins(first, end, axis, low, scale);
      fillRightCosts();
      double[] left = new double[6];
      clear(left, 0);
      int leftCount = 0;
      for (int bin = 0; bin < BINS - 1; bin++) {
        grow(left, 0, binBox, 6 * bin);
        leftCount += binCount[bin];
        double cost = leftCount * halfArea(left, 0) + rightCost[bin + 1];
        if (leftCount > 0 && leftCount < count && cost < best) {
          best = cost;
          bestAxis = axis;
          bestBin = bin;
        }
      }
    }
    return bestAxis < 0 ? first : partition(first, end, bestAxis, bestBin, centres);
  }

  private void fillBins(int first, int end, int axis, double low, double scale) {
    Arrays.fill(binCount, 0);
    for (int bin = 0; bin < BINS; bin++) {
      clear(binBox, 6 * bin);
    }
    for (int i = first; i < end; i++) {
      int bin = bin(order[i], axis, low, scale);
      binCount[bin]++;
      grow(binBox, 6 * bin, boxes, 6 * order[i]);
    }
  }

  /** Sets, for each bin, the cost of a leaf made of it and all later ones. */
  private void fillRightCosts() {
    double[] right = new double[6];
    clear(right, 0);
    int count = 0;
    for (int bin = BINS - 1; bin > 0; bin--) {
      grow(right, 0, binBox, 6 * bin);
      count += binCount[bin];
      rightCost[bin] = count == 0 ? 0 : count * halfArea(right, 0);
    }
  }

  private int partition(int first, int end, int axis, int lastLeft, double[] centres) {
    double low = centres[2 * axis];
    double scale = BINS / (centres[2 * axis + 1] - low);
    int middle = first;
    for (int i = first; i < end; i++) {
      if (bin(order[i], axis, low, scale) <= lastLeft) {
        swap(i, middle++);
      }
    }
    return middle;
  }

  private int bin(int item, int axis, double low, double scale) {
    return Math.min(BINS - 1, (int) ((centre(item, axis) - low) * scale));
  }

  private double centre(int item, int axis) {
    return .5 * boxes[6 * item + 2 * axis] + .5 * boxes[6 * item + 2 * axis + 1];
  }

  private void swap(int i, int j) {
    int item = order[i];
    order[i] = order[j];
    order[j] = item;
  }

  private static void clear(double[] box, int at) {
    for (int axis = 0; axis < 3; axis++) {
      box[at + 2 * axis] = Double.POSITIVE_INFINITY;
      box[at + 2 * axis + 1] = Double.NEGATIVE_INFINITY;
    }
  }

  private static void grow(double[] box, int at, double[] by, int byAt) {
    for (int axis = 0; axis < 6; axis += 2) {
      box[at + axis] = Math.min(box[at + axis], by[byAt + axis]);
      box[at + axis + 1] = Math.max(box[at + axis + 1], by[byAt + axis + 1]);
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
