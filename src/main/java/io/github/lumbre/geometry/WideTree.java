package io.github.lumbre.geometry;

import io.github.lumbre.geometry.internal.HierarchyLimitException;
import java.util.Arrays;

/**
 * A hierarchy of nodes with up to eight children each, and its triangles, as floats in the order
 * that vectors of eight floats need. Immutable.
 */
final class WideTree {
  /** The maximum number of children per node, and of triangles per leaf. */
  static final int WIDTH = 8;

  /**
   * The offset of a node's children, among their boxes: minima on x, maxima on x, then y, the
   * children, then z. Reading the boxes thus loads all cache lines of the node.
   */
  static final int CHILDREN = 4 * WIDTH;

  /** Integers per node. */
  private static final int NODE_SIZE = 7 * WIDTH;

  /**
   * Floats per triangle: its first vertex, the edges from it to the second and third vertices, its
   * {@linkplain #spread spread}, and the bits of its corners for {@link Triangles#intersectOne}.
   */
  private static final int TRIANGLE_SIZE = 13;

  /** The offset of the first corners in a block of triangles. */
  static final int CORNERS = 10 * WIDTH;

  /** A coordinate beyond the end of any ray. */
  private static final float FAR_AWAY = 0x1p126f;

  /** The maximum number of nodes whose leaves one task stores. */
  private static final int MAX_PART = 2048;

  static final LeafCost COSTS = new LeafCost(WIDTH, 1, .2, true);

  private final UnitSpace space;
  private final Triangles triangles;
  private final LeafShapes shapes;
  private final float[] leaves;
  private int[] nodes = new int[NODE_SIZE];
  private int size;

  /**
   * Creates the tree of a binary tree.
   *
   * @param lastPlace the largest number of a triangle's place that a leaf can start at
   * @throws HierarchyLimitException if there are more triangles than places
   */
  WideTree(BvhTree tree, BvhItems items, int lastPlace) {
    LeafOrder leafOrder = new LeafOrder(tree.order(), items.triangleCount(), WIDTH, lastPlace);
    WideCollapse collapse = new WideCollapse(tree);
    space = new UnitSpace(collapse.root().box());
    store(collapse.root(), collapse, leafOrder);
    nodes = Arrays.copyOf(nodes, size);
    int[] places = leafOrder.triangles();
    leaves = new float[Math.multiplyExact(places.length, TRIANGLE_SIZE)];
    Triangles all = items.triangles(places);
    RangeWork work = (first, end) -> storeLeaves(first, end, places, all.corners(), items);
    work.runAll(size / NODE_SIZE, MAX_PART);
    triangles = all.withoutCorners();
    shapes = items.shapes(leafOrder.shapes());
  }

  /** Returns the space of all floats of this tree. */
  UnitSpace space() {
    return space;
  }

  /**
   * Returns the nodes, with the root first. Each node starts with the float bits of its children's
   * boxes: eight minima on x, eight maxima on x, then y, then z. From {@link #CHILDREN} on, between
   * y and z, it holds the children: the offset of a node, or a {@link LeafRef}.
   */
  int[] nodes() {
    return nodes;
  }

  /**
   * Returns the triangles in blocks of {@link #WIDTH}: the first coordinate of all triangles of a
   * block, then the second, and so on. A leaf is a part of a block; some places are not used.
   */
  float[] leaves() {
    return leaves;
  }

  Triangles triangles() {
    return triangles;
  }

  /**
   * Returns the position in {@link #leaves} of the block of a triangle, given its position in leaf
   * order.
   */
  static int blockAt(int triangle) {
    return (triangle & -WIDTH) * TRIANGLE_SIZE;
  }

  LeafShapes shapes() {
    return shapes;
  }

  private int store(WideCollapse.Kept node, WideCollapse collapse, LeafOrder leafOrder) {
    int start = size;
    size += NODE_SIZE;
    if (size > nodes.length) {
      nodes = Arrays.copyOf(nodes, nodes.length * 2);
    }
    WideCollapse.Kept[] lanes = collapse.children(node);
    sortLikeliestLast(lanes);
    for (int lane = 0; lane < WIDTH; lane++) {
      if (lane < lanes.length) {
        storeBox(start + lane, lanes[lane].box());
      } else {
        storeNothing(start + lane);
      }
    }
    for (int lane = 0; lane < lanes.length; lane++) {
      WideCollapse.Kept kept = lanes[lane];
      int child =
          kept.isLeaf()
              ? leafOrder.add(kept.first(), kept.end())
              : store(kept, collapse, leafOrder);
      nodes[start + CHILDREN + lane] = child;
    }
    return start;
  }

  /**
   * Sorts a node's children. A traversal for any hit visits the last child first: leaves, which may
   * end it at once, then nodes with larger boxes, in which a hit is more likely (Nah &amp; Manocha
   * 2014, "SATO: Surface Area Traversal Order for Shadow Ray Tracing").
   */
  private static void sortLikeliestLast(WideCollapse.Kept[] lanes) {
    for (int lane = 1; lane < lanes.length; lane++) {
      WideCollapse.Kept moved = lanes[lane];
      int place = lane;
      while (place > 0 && isLikelier(lanes[place - 1], moved)) {
        lanes[place] = lanes[place - 1];
        place--;
      }
      lanes[place] = moved;
    }
  }

  private static boolean isLikelier(WideCollapse.Kept node, WideCollapse.Kept other) {
    if (node.isLeaf() != other.isLeaf()) {
      return node.isLeaf();
    }
    return ItemBox.halfArea(node.box()) > ItemBox.halfArea(other.box());
  }

  private void storeBox(int at, double[] box) {
    for (int axis = 0; axis < 3; axis++) {
      int minimum = at + sideAt(2 * axis);
      nodes[minimum] = Float.floatToRawIntBits(space.down(axis, box[2 * axis]));
      nodes[minimum + WIDTH] = Float.floatToRawIntBits(space.up(axis, box[2 * axis + 1]));
    }
  }

  /** Returns the offset of a side of all boxes of a node, of six sides. */
  private static int sideAt(int side) {
    return (side * WIDTH < CHILDREN ? side : side + 1) * WIDTH;
  }

  /** Stores a point that is farther away than the end of any ray. */
  private void storeNothing(int at) {
    for (int side = 0; side < 6; side++) {
      nodes[at + sideAt(side)] = Float.floatToRawIntBits(FAR_AWAY);
    }
  }

  /** Stores the triangles of the leaves below nodes with numbers in [first, end). */
  private void storeLeaves(int first, int end, int[] order, int[] corners, BvhItems items) {
    double[] vertices = new double[9];
    for (int node = first; node < end; node++) {
      for (int lane = 0; lane < WIDTH; lane++) {
        int child = nodes[node * NODE_SIZE + CHILDREN + lane];
        if (child < 0 && !LeafRef.isOfShapes(child)) {
          int place = LeafRef.first(child);
          int count = LeafRef.count(child);
          for (int i = 0; i < count; i++) {
            items.copyVertices(order[place + i], vertices);
            int at = blockAt(place) + place % WIDTH + i;
            storeTriangle(at, vertices);
            storeCorners(at + CORNERS, corners, 3 * (place + i));
          }
        }
      }
    }
  }

  private void storeTriangle(int at, double[] v) {
    double scale = space.scale;
    double bx = (v[3] - v[0]) * scale;
    double by = (v[4] - v[1]) * scale;
    double bz = (v[5] - v[2]) * scale;
    double cx = (v[6] - v[0]) * scale;
    double cy = (v[7] - v[1]) * scale;
    double cz = (v[8] - v[2]) * scale;
    leaves[at] = space.nearest(0, v[0]);
    leaves[at + WIDTH] = space.nearest(1, v[1]);
    leaves[at + 2 * WIDTH] = space.nearest(2, v[2]);
    leaves[at + 3 * WIDTH] = (float) bx;
    leaves[at + 4 * WIDTH] = (float) by;
    leaves[at + 5 * WIDTH] = (float) bz;
    leaves[at + 6 * WIDTH] = (float) cx;
    leaves[at + 7 * WIDTH] = (float) cy;
    leaves[at + 8 * WIDTH] = (float) cz;
    leaves[at + 9 * WIDTH] = Math.nextUp((float) spread(v));
  }

  private void storeCorners(int at, int[] corners, int first) {
    for (int i = 0; i < 3; i++) {
      leaves[at + i * WIDTH] = Float.intBitsToFloat(corners[first + i]);
    }
  }

  /**
   * Returns E + E²/2, where E is the longest extent of an edge along an axis, in the tree's space.
   * The errors of a triangle's edge functions are proportional to it.
   */
  private double spread(double[] v) {
    double longest =
        Math.max(
            Axes.largest(v[0] - v[3], v[1] - v[4], v[2] - v[5]),
            Math.max(
                Axes.largest(v[3] - v[6], v[4] - v[7], v[5] - v[8]),
                Axes.largest(v[6] - v[0], v[7] - v[1], v[8] - v[2])));
    double extent = longest * space.scale;
    return extent + .5 * extent * extent;
  }
}
