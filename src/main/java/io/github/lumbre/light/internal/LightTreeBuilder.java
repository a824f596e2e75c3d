package io.github.lumbre.light.internal;

import io.github.lumbre.light.LightBounds;
import java.util.Comparator;
import java.util.List;

/**
 * Builds the nodes of a {@link LightTree} by recursively dividing emitters into groups that are
 * close in position and direction. Mutable, used once.
 */
final class LightTreeBuilder {
  /**
   * From this depth on, both halves get equal numbers of emitters, which limits the depth of the
   * tree.
   */
  private static final int DEEPEST_UNEVEN = 40;

  private static final int AXES = 3;

  /**
   * A node of the tree. The right child follows the left one.
   *
   * @param bounds bounds of all emitters in the node
   * @param size number of emitters in the node
   * @param parent index of the parent; 0 for the root, whose own index is 0
   * @param child index of the left child; for a leaf, ~emitter
   */
  record Node(LightBounds bounds, int size, int parent, int child) {}

  /** An emitter, given by its index in the scene, with its bounds. */
  record Item(int emitter, LightBounds bounds) {}

  /** A position at which a sorted list can be divided, and the cost of doing so. */
  private record Split(int axis, int at, double cost) {}

  private final Node[] nodes;
  private int next = 1;

  private LightTreeBuilder(int emitters) {
    nodes = new Node[2 * emitters - 1];
  }

  /** Returns the nodes of a tree over at least one emitter, the root first. Reorders the list. */
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

  /**
   * Sorts the emitters along the cheapest axis and returns how many of them belong to the left
   * child.
   */
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
        Comparator.comparingDouble((Item item) -> item.bounds.box().center().get(axis))
            .thenComparingInt(item -> item.emitter));
  }

  /**
   * Returns the cheapest split of a list sorted along an axis; among equally cheap ones, the split
   * nearest the middle.
   */
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
