package io.github.lumbre.geometry;

import java.util.Arrays;
import java.util.Comparator;

/**
 * A hierarchy of nodes with up to eight children each, and its triangles, as floats in the order
 * that vectors of eight floats need. Immutable.
 */
final class WideTree {
  /** The maximum number of children per node, and of triangles per leaf. */
  static final int WIDTH = 8;

  /**
   * The offset of a node's children, after their boxes: minima on x, maxima on x, then y, then z.
   */
  static final int CHILDREN = 6 * WIDTH;

  /** Integers per node. */
  private static final int NODE_SIZE = 7 * WIDTH;

  /**
   * Floats per triangle: its first vertex, the edges from it to the second and third vertices,
   * their cross product, and its {@linkplain #spread spread}.
   */
  static final int TRIANGLE_SIZE = 13;

  static final LeafCost COSTS = new LeafCost(WIDTH, 1, .2);

  /**
   * The order of a node's children. A traversal for any hit visits the last child first: leaves,
   * which may end it at once, then nodes with larger boxes, in which a hit is more likely (Nah
   * &amp; Manocha 2014, "SATO: Surface Area Traversal Order for Shadow Ray Tracing").
   */
  private static final Comparator<WideCollapse.Kept> LIKELIEST_LAST =
      Comparator.comparing((WideCollapse.Kept kept) -> kept.node() instanceof BvhNode.Leaf)
          .thenComparingDouble(kept -> BvhSplitter.halfArea(kept.node().box(), 0));

  private final UnitSpace space;
  private final Triangles triangles;
  private final LeafShapes shapes;
  private final float[] leaves;
  private int[] nodes = new int[NODE_SIZE];
  private int size;

  WideTree(BvhNode tree, int[] order, BvhItems items) {
    space = new UnitSpace(tree.box());
    LeafOrder leafOrder = new LeafOrder(order, items.triangleCount());
    leaves = new float[items.triangleCount() * TRIANGLE_SIZE + WIDTH];
    store(WideCollapse.root(tree), new WideCollapse(tree), leafOrder, items);
    nodes = Arrays.copyOf(nodes, size);
    triangles = items.triangles(leafOrder.triangles());
    shapes = items.shapes(leafOrder.shapes());
  }

  /** Returns the space of all floats of this tree. */
  UnitSpace space() {
    return space;
  }

  /**
   * Returns the nodes, with the root first. Each node starts with the float bits of its children's
   * boxes: eight minima on x, eight maxima on x, then y, then z. From {@link #CHILDREN} on, it
   * holds the children: the offset of a node, or a {@link LeafRef}.
   */
  int[] nodes() {
    return nodes;
  }

  /**
   * Returns {@link #TRIANGLE_SIZE} floats per triangle. Each leaf stores the first coordinate of
   * all its triangles, then the second, and so on. Padding follows the last triangle, because
   * vectors may read beyond it.
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
    int start = size;
    size += NODE_SIZE;
    if (size > nodes.length) {
      nodes = Arrays.copyOf(nodes, nodes.length * 2);
    }
    WideCollapse.Kept[] lanes = collapse.children(node);
    Arrays.sort(lanes, LIKELIEST_LAST);
    for (int lane = 0; lane < WIDTH; lane++) {
      storeBox(start + lane, lane < lanes.length ? lanes[lane].node().box() : BvhNode.EMPTY);
    }
    for (int lane = 0; lane < lanes.length; lane++) {
      int child =
          lanes[lane].node() instanceof BvhNode.Leaf leaf
              ? storeLeaf(leaf, leafOrder, items)
              : store(lanes[lane], collapse, leafOrder, items);
      nodes[start + CHILDREN + lane] = child;
    }
    return start;
  }

  private void storeBox(int at, double[] box) {
    for (int axis = 0; axis < 3; axis++) {
      int minimum = at + 2 * axis * WIDTH;
      nodes[minimum] = Float.floatToRawIntBits(space.down(axis, box[2 * axis]));
      nodes[minimum + WIDTH] = Float.floatToRawIntBits(space.up(axis, box[2 * axis + 1]));
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
    for (int k = 0; k < 3; k++) {
      leaves[at + k * stride] = space.nearest(k, vertices[k]);
      int next = (k + 1) % 3;
      int last = (k + 2) % 3;
      leaves[at + (3 + k) * stride] = (float) edge(vertices, 1, k);
      leaves[at + (6 + k) * stride] = (float) edge(vertices, 2, k);
      leaves[at + (9 + k) * stride] =
          (float)
              (edge(vertices, 1, next) * edge(vertices, 2, last)
                  - edge(vertices, 1, last) * edge(vertices, 2, next));
    }
    leaves[at + 12 * stride] = Math.nextUp((float) spread(vertices));
  }

  /**
   * Returns a coordinate of the edge from the first vertex to another vertex, in the tree's space.
   */
  private double edge(double[] vertices, int vertex, int axis) {
    return (vertices[3 * vertex + axis] - vertices[axis]) * space.scale;
  }

  /**
   * Returns E + E²/2, where E is the longest extent of an edge along an axis, in the tree's space.
   * The errors of a triangle's edge functions are proportional to it.
   */
  private double spread(double[] vertices) {
    double longest = 0;
    for (int k = 0; k < 9; k++) {
      longest = Math.max(longest, Math.abs(vertices[k] - vertices[(k + 3) % 9]));
    }
    double extent = longest * space.scale;
    return extent + .5 * extent * extent;
  }
}
