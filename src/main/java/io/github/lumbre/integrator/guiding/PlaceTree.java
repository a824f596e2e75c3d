package io.github.lumbre.integrator.guiding;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.IntUnaryOperator;

/** The binary tree of the places of an order of records. Its leaves are cells. */
final class PlaceTree {
  /** The largest number of records in a cell, unless they cannot be divided. */
  static final int MOST_RECORDS = 1600;

  /** The smallest number of records in a cell. */
  static final int LEAST_RECORDS = 100;

  /** A cell is halved in space, unless one half would have less than this part of the records. */
  private static final int LEAST_PART = 8;

  private final RecordOrder order;
  private final List<RecordRange> leaves = new ArrayList<>();
  private final int root;
  private int[] places = new int[64];
  private int size;

  /** Builds the tree, and sorts the order by its leaves. */
  PlaceTree(RecordOrder order) {
    this.order = order;
    root = order.size() < LEAST_RECORDS ? Guide.NO_CELL : place(0, order.size());
  }

  List<RecordRange> leaves() {
    return Collections.unmodifiableList(leaves);
  }

  /** Returns the number of ints of all nodes. */
  int size() {
    return size;
  }

  /**
   * Copies the nodes to where they are used.
   *
   * @param to where they start
   * @param cells returns the cell of a leaf
   * @return the root: a node, a cell or {@link Guide#NO_CELL}
   */
  int copy(int[] target, int to, IntUnaryOperator cells) {
    for (int node = 0; node < size; node += Guide.PLACE_STRIDE) {
      target[to + node] = places[node];
      target[to + node + 1] = places[node + 1];
      target[to + node + 2] = moved(places[node + 2], to, cells);
      target[to + node + 3] = moved(places[node + 3], to, cells);
    }
    return root == Guide.NO_CELL ? root : moved(root, to, cells);
  }

  private static int moved(int node, int by, IntUnaryOperator cells) {
    return node >= 0 ? node + by : Guide.leaf(cells.applyAsInt(Guide.leaf(node)));
  }

  /** Adds the tree of a range; returns its root. */
  private int place(int from, int to) {
    int count = to - from;
    if (count <= MOST_RECORDS) {
      return leaf(from, to);
    }
    RecordOrder.Extent extent = order.extent(from, to);
    int axis = extent.widest();
    float limit = extent.center(axis);
    int middle = order.divide(from, to, axis, limit);
    if (Math.min(middle - from, to - middle) < count / LEAST_PART) {
      limit = order.median(from, to, axis);
      middle = order.divide(from, to, axis, limit);
    }
    if (Math.min(middle - from, to - middle) < LEAST_RECORDS) {
      return leaf(from, to);
    }
    int node = size;
    size += Guide.PLACE_STRIDE;
    if (places.length < size) {
      places = Arrays.copyOf(places, 2 * places.length);
    }
    places[node] = axis;
    places[node + 1] = Float.floatToRawIntBits(limit);
    int low = place(from, middle);
    int high = place(middle, to);
    places[node + 2] = low;
    places[node + 3] = high;
    return node;
  }

  private int leaf(int from, int to) {
    leaves.add(new RecordRange(order, from, to));
    return Guide.leaf(leaves.size() - 1);
  }
}
