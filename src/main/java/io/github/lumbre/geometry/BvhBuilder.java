package io.github.lumbre.geometry;

import io.github.lumbre.geometry.internal.HierarchyLimitException;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ForkJoinTask;

/**
 * Builds a binary hierarchy over boxes from the top down with the binned surface area heuristic.
 * Source: Wald 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies". Mutable; each
 * instance builds one tree.
 *
 * <p>For wide nodes, the walls of a room are separated from its contents first; see {@link
 * BuildItems#partitionLarge}.
 *
 * <p>A leaf holds triangles or other shapes, not both. Large ranges are built in parallel by the
 * fork-join pool in which {@link #build} is called, or by the common pool. Each task owns a fixed
 * range of the order, so the tree does not depend on the number of threads.
 *
 * <p>If the calling thread is interrupted, the build stops at the next large range.
 */
final class BvhBuilder {
  /** The maximum depth of a leaf. */
  static final int MAX_DEPTH = 96;

  /** The maximum number of items. */
  static final int MAX_ITEMS = (1 << 26) - 1;

  /**
   * Below this depth, ranges are halved, which adds at most 31 levels and one more to separate the
   * kinds.
   */
  private static final int MAX_SAH_DEPTH = 60;

  /** Ranges with fewer items do not get their own task. */
  private static final int MIN_TASK = 4096;

  /** Coordinates of ranges with a smaller extent are set again, at a finer resolution. */
  private static final int MIN_EXTENT = 1 << 14;

  private final BvhItems source;
  private final BuildItems items;
  private final LeafCost costs;

  /** The children of each inner node, as {@link BvhTree} has them; each task sets its own ones. */
  private final int[] children;

  /** The thread whose interrupt cancels the build; every task checks its status. */
  private final Thread owner = Thread.currentThread();

  private volatile boolean cancelled;

  /**
   * Creates a builder of the tree over items; there must be at least one.
   *
   * @throws HierarchyLimitException if there are more than {@link #MAX_ITEMS}
   */
  BvhBuilder(BvhItems items, LeafCost costs) {
    requirePlaces(items);
    source = items;
    this.items = new BuildItems(items, costs);
    this.costs = costs;
    children = new int[2 * items.count()];
  }

  /**
   * Checks the number of items.
   *
   * @throws HierarchyLimitException if there are more than {@link #MAX_ITEMS}
   */
  static void requirePlaces(BvhItems items) {
    if (items.count() > MAX_ITEMS) {
      throw new HierarchyLimitException(
          "expected at most 2^26 - 1 triangles and other shapes in one hierarchy, found "
              + items.count());
    }
  }

  /**
   * Returns the tree over all items.
   *
   * @throws CancellationException if the thread that created this builder is interrupted
   */
  BvhTree build() {
    int large = costs.isWide() ? items.partitionLarge() : 0;
    int root = large;
    if (large == 0) {
      root = build(0, items.count(), 0, newSplitter());
    } else {
      children[2 * large] = build(0, large, 1, new BvhSplitter(items.array(), costs.ofLarge()));
      children[2 * large + 1] = build(large, items.count(), 1, newSplitter());
    }
    return new BvhTree(source, items.order(), children, root);
  }

  private BvhSplitter newSplitter() {
    return new BvhSplitter(items.array(), costs);
  }

  /** Builds the node over a range; returns it. */
  private int build(int first, int end, int depth, BvhSplitter splitter) {
    if (end - first == 1) {
      return BvhTree.LEAF;
    }
    measure(first, end, splitter);
    int middle = depth < MAX_SAH_DEPTH ? splitter.split(first, end) : first;
    if (middle == first && splitter.fitsLeaf()) {
      middle = items.partitionKinds(first, end);
      if (middle == first || middle == end) {
        return BvhTree.LEAF;
      }
    } else if (middle == first) {
      middle = (first + end) >>> 1;
    }
    buildChildren(first, middle, end, depth + 1, splitter);
    return middle;
  }

  private void measure(int first, int end, BvhSplitter splitter) {
    splitter.measure(first, end);
    if (splitter.extent() < MIN_EXTENT) {
      items.quantize(first, end);
      splitter.measure(first, end);
    }
  }

  private void buildChildren(int first, int middle, int end, int depth, BvhSplitter splitter) {
    if (end - first >= MIN_TASK) {
      checkInterrupt();
    }
    if (Math.min(middle - first, end - middle) < MIN_TASK) {
      children[2 * middle] = build(first, middle, depth, splitter);
      children[2 * middle + 1] = build(middle, end, depth, splitter);
      return;
    }
    ForkJoinTask<Integer> right =
        ForkJoinTask.adapt(() -> build(middle, end, depth, newSplitter())).fork();
    children[2 * middle] = build(first, middle, depth, splitter);
    children[2 * middle + 1] = joined(right);
  }

  /** Waits for a task. Unlike {@code join}, this passes an interrupt on to the other tasks. */
  private int joined(ForkJoinTask<Integer> task) {
    try {
      return task.get();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      cancelled = true;
      throw new CancellationException("building the hierarchy was interrupted");
    } catch (ExecutionException e) {
      // Rethrows the task's exception.
      return task.join();
    }
  }

  private void checkInterrupt() {
    if (cancelled || owner.isInterrupted()) {
      // The owner may clear its interrupt status while other threads still build.
      cancelled = true;
      throw new CancellationException("building the hierarchy was interrupted");
    }
  }
}
