package io.github.lumbre.light;

import java.util.Comparator;
import java.util.List;

/** Divides emitters into halves that lie and shine together, over and over. Mutable, used once. */
final class LightTreeBuilder {
  /** From this depth on halves are of equal number, so that no path becomes long. */
  private static final int DEEPEST_UNEVEN = 40;

  private static final int AXES = 3;

  /**
   * A node of the tree. The right child lies beside the left one.
   *
   * @param size how many emitters it holds
   * @param parent the number of the parent; 0 for the root, whose own number is 0
   * @param child the number of the left child; of a leaf, ~emitter
   */
  record Node(LightBounds bounds, int size, int parent, int child) {}

  /** An emitter by its index. */
  record Item(int emitter, LightBounds bounds) {}

  /** A place to divide a sorted list at, and how bad that would be. */
  private record Split(int axis, int at, double cost) {}

  private final Node[] nodes;
  private int next = 1;

  private LightTreeBuilder(int emitters) {
    nodes = new Node[2 * emitters - 1];
  }

  /** Returns the nodes of a tree over at least one emitter; sorts the list. */
  static Node[] build(List<Item> items) {
    LightTreeBuilder builder = new LightTreeBuilder(items.size());
    builder.fill(0, 0, 0, items);
    return builder.nodes;
  }

  private LightBounds fill(int node, int parent, int depth, List<Item> items) {
    if (items.size() == 1) {
      Item item = items.get(0);
      nodes[node] = new Node(item.bounds(), 1, parent, ~item.emitter());
      return item.bounds();
    }
    int left = next;
    next += 2;
    int middle = divide(items, depth);
    LightBounds one = fill(left, node, depth + 1, items.subList(0, middle));
    LightBounds other = fill(left + 1, node, depth + 1, items.subList(middle, items.size()));
    LightBounds bounds = one.union(other);
    nodes[node] = new Node(bounds, items.size(), parent, left);
    return bounds;
  }

  /** Sorts the emitters and returns how many of them go left. */
  private static int divide(List<Item> items, int depth) {
    Split best = new Split(0, items.size() / 2, Double.POSITIVE_INFINITY);
    for (int axis = 0; axis < AXES; axis++) {
      sort(items, axis);
      Split split = cheapest(items, axis);
      if (split.cost < best.cost) {
        best = split;
      }
    }
    sort(items, best.axis);
    return depth < DEEPEST_UNEVEN ? best.at : items.size() / 2;
  }

  private static void sort(List<Item> items, int axis) {
    items.sort(
        Comparator.comparingDouble((Item item) -> item.bounds.box().centre().get(axis))
            .thenComparingInt(item -> item.emitter));
  }

  /** Returns the cheapest place; among equally cheap ones the one nearest the middle. */
  private static Split cheapest(List<Item> items, int axis) {
    int size = items.size();
    double[] costs = new double[size];
    LightBounds bounds = items.get(0).bounds;
    for (int i = 1; i < size; i++) {
      costs[i] = bounds.cost();
      bounds = bounds.union(items.get(i).bounds);
    }
    bounds = items.get(size - 1).bounds;
    Split best = new Split(axis, size / 2, Double.POSITIVE_INFINITY);
    for (int i = size - 1; i > 0; i--) {
      double cost = costs[i] + bounds.cost();
      boolean isNearer = Math.abs(i - size / 2) < Math.abs(best.at - size / 2);
      if (cost < best.cost || cost == best.cost && isNearer) {
        best = new Split(axis, i, cost);
      }
      bounds = bounds.union(items.get(i - 1).bounds);
    }
    return best;
  }
}
