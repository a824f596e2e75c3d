package io.github.lumbre.geometry;

import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ForkJoinTask;

/**
 * Builds a binary hierarchy over boxes, from the top down, by the binned surface area heuristic:
 * Wald 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies". Mutable, used once.
 *
 * <p>An item is known by its number. Those below {@code triangles} are triangles, the others are
 * shapes; a leaf holds one kind only. Large ranges are built by the threads of the fork-join pool
 * in which {@link #build} is called, or else of the common one. Each works on a part of the order
 * that was its before it began, so that the tree does not depend on their number.
 *
 * <p>An interrupt of the thread that calls ends the building at the next large range.
 */
final class BvhBuilder {
  /** Deepest leaf. */
  static final int MAX_DEPTH = 96;

  /** The most items there may be. */
  static final int MAX_ITEMS = (1 << 26) - 1;

  /** Below this depth ranges are halved, which adds at most 31 levels, and a last one by kind. */
  private static final int MAX_SAH_DEPTH = 60;

  /** Smaller ranges are not worth a task of their own. */
  private static final int MIN_TASK = 4096;

  private final double[] boxes;
  private final int[] order;
  private final int triangles;
  private final LeafCost costs;

  /** The thread whose interrupt ends the building, whichever thread notices. */
  private final Thread owner = Thread.currentThread();

  private volatile boolean cancelled;

  /**
   * @param boxes six doubles an item: minimum and maximum on x, y, z; finite; will be reordered
   * @param triangles how many of the items, the first ones, are triangles
   */
  BvhBuilder(double[] boxes, int triangles, LeafCost costs) {
    this.boxes = boxes;
    this.triangles = triangles;
    this.costs = costs;
    int items = boxes.length / 6;
    if (items > MAX_ITEMS) {
      throw new IllegalArgumentException("items: expected at most 2^26 - 1, found " + items);
    }
    order = new int[items];
    for (int i = 0; i < items; i++) {
      order[i] = i;
    }
  }

  /**
   * Returns the tree over all items; there must be at least one.
   *
   * @throws CancellationException if the thread that made this is interrupted
   */
  BvhNode build() {
    return build(0, order.length, 0, newSplitter());
  }

  /** Returns the items' numbers in the order of the leaves, once they are built. */
  int[] order() {
    return order;
  }

  private BvhSplitter newSplitter() {
    return new BvhSplitter(boxes, order, triangles, costs);
  }

  private BvhNode build(int first, int end, int depth, BvhSplitter splitter) {
    double[] box = splitter.measure(first, end);
    if (end - first == 1) {
      return new BvhNode.Leaf(box, first, end);
    }
    int middle = depth < MAX_SAH_DEPTH ? splitter.split(first, end) : first;
    if (middle == first && splitter.fitsLeaf()) {
      middle = splitter.partitionKinds(first, end);
      if (middle == first || middle == end) {
        return new BvhNode.Leaf(box, first, end);
      }
    } else if (middle == first) {
      middle = (first + end) >>> 1;
    }
    return buildInner(box, first, middle, end, depth + 1, splitter);
  }

  private BvhNode buildInner(
      double[] box, int first, int middle, int end, int depth, BvhSplitter splitter) {
    if (end - first >= MIN_TASK) {
      checkInterrupt();
    }
    if (Math.min(middle - first, end - middle) < MIN_TASK) {
      BvhNode left = build(first, middle, depth, splitter);
      return new BvhNode.Inner(box, left, build(middle, end, depth, splitter));
    }
    ForkJoinTask<BvhNode> right =
        ForkJoinTask.adapt(() -> build(middle, end, depth, newSplitter())).fork();
    BvhNode left = build(first, middle, depth, splitter);
    return new BvhNode.Inner(box, left, joined(right));
  }

  /** Waits for a task; unlike its own join, this does not hide an interrupt from other tasks. */
  private BvhNode joined(ForkJoinTask<BvhNode> task) {
    try {
      return task.get();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      cancelled = true;
      throw new CancellationException("building the hierarchy was interrupted");
    } catch (ExecutionException e) {
      // Throws what the task has thrown.
      return task.join();
    }
  }

  private void checkInterrupt() {
    if (cancelled || owner.isInterrupted()) {
      // The owner may clear its status while other threads still build.
      cancelled = true;
      throw new CancellationException("building the hierarchy was interrupted");
    }
  }
}
