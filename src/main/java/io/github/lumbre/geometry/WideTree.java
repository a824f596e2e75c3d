package io.github.lumbre.geometry;

import java.util.Arrays;

/**
 * A hierarchy of nodes with up to eight children each, and its triangles, as floats in the order in
 * which vectors of eight floats are read. Immutable.
 */
final class WideTree {
  /** Children a node, and triangles a leaf. */
  static final int WIDTH = 8;

  /** Floats a node: the minima of the children's boxes on x, then the maxima, then y, then z. */
  static final int NODE_SIZE = 6 * WIDTH;

  /** Floats a triangle: three vertices and the longest extent of an edge along an axis. */
  static final int TRIANGLE_SIZE = 10;

  static final LeafCost COSTS = new LeafCost(WIDTH, 1, .2);

  private final UnitSpace space;
  private final Triangles triangles;
  private final LeafShapes shapes;
  private final float[] leaves;
  private float[] nodes = new float[NODE_SIZE];
  private int[] children = new int[WIDTH];
  private int nodeCount;

  WideTree(BvhNode tree, int[] order, BvhItems items) {
    space = new UnitSpace(tree.box());
    LeafOrder leafOrder = new LeafOrder(order, items.triangleCount());
    leaves = new float[items.triangleCount() * TRIANGLE_SIZE + WIDTH];
    store(WideCollapse.root(tree), new WideCollapse(tree), leafOrder, items);
    nodes = Arrays.copyOf(nodes, nodeCount * NODE_SIZE);
    children = Arrays.copyOf(children, nodeCount * WIDTH);
    triangles = items.triangles(leafOrder.triangles(), false);
    shapes = items.shapes(leafOrder.shapes());
  }

  /** Returns the space of all floats here. */
  UnitSpace space() {
    return space;
  }

  /** Returns the children's boxes, {@link #NODE_SIZE} floats a node; the root is the first. */
  float[] nodes() {
    return nodes;
  }

  /** Returns eight children a node: a node's number times eight, or a {@link LeafRef}. */
  int[] children() {
    return children;
  }

  /**
   * Returns {@link #TRIANGLE_SIZE} floats a triangle: for each leaf the first coordinate of all its
   * triangles, then the second, and so on; after the last, what may be read in vain.
   */
  float[] leaves() {
    return leaves;
  }

  Triangles triangles() {
    return triangles;
  }

  LeafShapes shapes() {
    return shapes;
  }

  private int store(
      WideCollapse.Kept node, WideCollapse collapse, LeafOrder leafOrder, BvhItems items) {
    int number = nodeCount++;
    if (nodeCount * WIDTH > children.length) {
      nodes = Arrays.copyOf(nodes, nodes.length * 2);
      children = Arrays.copyOf(children, children.length * 2);
    }
    WideCollapse.Kept[] lanes = collapse.children(node);
    for (int lane = 0; lane < WIDTH; lane++) {
      storeBox(
          number * NODE_SIZE + lane,
          lane < lanes.length ? lanes[lane].node().box() : BvhNode.EMPTY);
    }
    for (int lane = 0; lane < lanes.length; lane++) {
      int child =
          lanes[lane].node() instanceof BvhNode.Leaf leaf
              ? storeLeaf(leaf, leafOrder, items)
              : WIDTH * store(lanes[lane], collapse, leafOrder, items);
      children[number * WIDTH + lane] = child;
    }
    return number;
  }

  private void storeBox(int at, double[] box) {
    for (int axis = 0; axis < 3; axis++) {
      nodes[at + 2 * axis * WIDTH] = space.down(axis, box[2 * axis]);
      nodes[at + (2 * axis + 1) * WIDTH] = space.up(axis, box[2 * axis + 1]);
    }
  }

  private int storeLeaf(BvhNode.Leaf leaf, LeafOrder leafOrder, BvhItems items) {
    int reference = leafOrder.add(leaf);
    if (!LeafRef.isOfShapes(reference)) {
      int count = LeafRef.count(reference);
      double[] vertices = new double[9];
      for (int lane = 0; lane < count; lane++) {
        int place = LeafRef.first(reference) + lane;
        items.copyVertices(leafOrder.triangles()[place], vertices);
        storeTriangle(LeafRef.first(reference) * TRIANGLE_SIZE + lane, count, vertices);
      }
    }
    return reference;
  }

  private void storeTriangle(int at, int stride, double[] vertices) {
    for (int k = 0; k < 9; k++) {
      leaves[at + k * stride] = space.nearest(k % 3, vertices[k]);
    }
    double longest = 0;
    for (int k = 0; k < 9; k++) {
      longest = Math.max(longest, Math.abs(vertices[k] - vertices[(k + 3) % 9]));
    }
    leaves[at + 9 * stride] = Math.nextUp((float) (longest * space.scale));
  }
}
