package io.github.lumbre.geometry;

import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ForkJoinTask;

/**
 * Builds a binary hierarchy over boxes from the top down with the binned surface area heuristic.
 * Source: Wald 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies". Mutable; each
 * instance builds one tree.
 *
 * <p>Items are numbered. Items below {@code triangles} are triangles, the others are shapes; a leaf
 * holds items of one kind. Large ranges are built in parallel by the fork-join pool in which {@link
 * #build} is called, or by the common pool. Each task owns a fixed range of the order, so the tree
 * does not depend on the number of threads.
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

  private final double[] boxes;
  private final int[] order;
  private final int triangles;
  private final LeafCost costs;

  /** The thread whose interrupt cancels the build; every task checks its status. */
  private final Thread owner = Thread.currentThread();

  private volatile boolean cancelled;

  /**
   * @param boxes six doubles per item: minimum and maximum on x, y, z; finite; reordered in place
   * @param triangles the number of triangles, which are the first items
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
   * @throws CancellationException if the thread that created this builder is interrupted
   */
  BvhNode build() {
    return build(0, order.length, 0, newSplitter());
  }

  /** Returns the item numbers in leaf order; valid after {@link #build}. */
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

  /** Waits for a task. Unlike {@code join}, this passes an interrupt on to the other tasks. */
  private BvhNode joined(ForkJoinTask<BvhNode> task) {
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
