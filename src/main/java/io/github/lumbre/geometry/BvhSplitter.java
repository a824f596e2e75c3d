package io.github.lumbre.geometry;

import java.util.Arrays;

/**
 * Finds where to split ranges of {@link BuildItems}, and reorders the items. Mutable; one instance
 * per thread, which works only on its own range of the shared items.
 *
 * <p>All bounds are integers, whose minimum and maximum take no branch.
 */
final class BvhSplitter {
  private static final int BINS = 16;

  private static final int SIZE = BuildItems.SIZE;

  /** The empty boxes of one axis' bins. */
  private static final int[] EMPTY_BINS = emptyBins();

  private final int[] items;
  private final LeafCost costs;

  /** The box of the last measured range, and its weight. */
  private final int[] range = new int[6];

  private int weight;

  /** Minimum and maximum on x, y, z of the items' centers in that range, times two. */
  private final int[] centres = new int[6];

  /** The boxes of each axis' bins, and their weights. Bins that are not in use hold old values. */
  private final int[] binBox = new int[3 * BINS * SIZE];

  private final int[] binWeight = new int[3 * BINS];
  private final double[] rightCost = new double[BINS];
  private final int[] side = new int[6];
  private int bins;

  /**
   * Creates a splitter.
   *
   * @param items the array of {@link BuildItems}
   */
  BvhSplitter(int[] items, LeafCost costs) {
    this.items = items;
    this.costs = costs;
  }

  /** Selects a range for the other methods. */
  void measure(int first, int end) {
    weight = 0;
    for (int axis = 0; axis < 6; axis += 2) {
      measure(first, end, axis);
    }
    for (int at = SIZE * first + BuildItems.WEIGHT; at < SIZE * end; at += SIZE) {
      weight += items[at];
    }
  }

  /** Measures along one axis, 0, 2 or 4, in local variables, so that the JIT uses registers. */
  private void measure(int first, int end, int axis) {
    int[] all = items;
    int low = Integer.MAX_VALUE;
    int high = Integer.MIN_VALUE;
    int lowCentre = Integer.MAX_VALUE;
    int highCentre = Integer.MIN_VALUE;
    for (int at = SIZE * first + axis; at < SIZE * end; at += SIZE) {
      int min = all[at];
      int max = all[at + 1];
      low = Math.min(low, min);
      high = Math.max(high, max);
      lowCentre = Math.min(lowCentre, min + max);
      highCentre = Math.max(highCentre, min + max);
    }
    range[axis] = low;
    range[axis + 1] = high;
    centres[axis] = lowCentre;
    centres[axis + 1] = highCentre;
  }

  /** Returns the longest edge of the measured range's box. */
  int extent() {
    return Math.max(range[1] - range[0], Math.max(range[3] - range[2], range[5] - range[4]));
  }

  /** Returns whether the measured range may become one leaf, or two leaves of different kinds. */
  boolean fitsLeaf() {
    return costs.units(weight) <= costs.maxUnits();
  }

  /**
   * Returns the position at which to split the reordered range. Returns {@code first} if a split is
   * impossible or does not pay.
   */
  int split(int first, int end) {
    bins = Math.min(BINS, 2 * (end - first));
    fillBins(first, end);
    double best =
        fitsLeaf()
            ? halfArea(range) * (costs.units(weight) - costs.nodeCost())
            : Double.POSITIVE_INFINITY;
    int bestAxis = -1;
    int bestBin = 0;
    for (int axis = 0; axis < 3; axis++) {
      fillRightCosts(axis);
      clear(side);
      int left = 0;
      int last = -1;
      for (int bin = 0; bin < bins; bin++) {
        int added = binWeight[BINS * axis + bin];
        if (added == 0) {
          continue;
        }
        if (last >= 0) {
          double cost = costs.partCost(left, weight) * halfArea(side) + rightCost[bin];
          if (cost < best) {
            best = cost;
            bestAxis = axis;
            bestBin = last;
          }
        }
        growByBin(axis, bin);
        left += added;
        last = bin;
      }
    }
    return bestAxis < 0 ? first : partition(first, end, bestAxis, bestBin);
  }

  private void fillBins(int first, int end) {
    Arrays.fill(binWeight, 0);
    for (int axis = 0; axis < 3; axis++) {
      System.arraycopy(EMPTY_BINS, 0, binBox, SIZE * BINS * axis, SIZE * bins);
    }
    int[] all = items;
    int lowX = centres[0];
    int lowY = centres[2];
    int lowZ = centres[4];
    long scaleX = binScale(0);
    long scaleY = binScale(1);
    long scaleZ = binScale(2);
    for (int at = SIZE * first; at < SIZE * end; at += SIZE) {
      int minX = all[at];
      int maxX = all[at + 1];
      int minY = all[at + 2];
      int maxY = all[at + 3];
      int minZ = all[at + 4];
      int maxZ = all[at + 5];
      int added = all[at + BuildItems.WEIGHT];
      add(bin(minX + maxX - lowX, scaleX), added, minX, maxX, minY, maxY, minZ, maxZ);
      add(BINS + bin(minY + maxY - lowY, scaleY), added, minX, maxX, minY, maxY, minZ, maxZ);
      add(2 * BINS + bin(minZ + maxZ - lowZ, scaleZ), added, minX, maxX, minY, maxY, minZ, maxZ);
    }
  }

  /** Adds an item, given by its weight and box, to a bin. */
  private void add(int bin, int added, int minX, int maxX, int minY, int maxY, int minZ, int maxZ) {
    int[] box = binBox;
    int at = SIZE * bin;
    binWeight[bin] += added;
    box[at] = Math.min(box[at], minX);
    box[at + 1] = Math.max(box[at + 1], maxX);
    box[at + 2] = Math.min(box[at + 2], minY);
    box[at + 3] = Math.max(box[at + 3], maxY);
    box[at + 4] = Math.min(box[at + 4], minZ);
    box[at + 5] = Math.max(box[at + 5], maxZ);
  }

  /** Sets, for each bin with items of an axis, the cost of a part that holds it and later bins. */
  private void fillRightCosts(int axis) {
    clear(side);
    int right = 0;
    for (int bin = bins - 1; bin > 0; bin--) {
      int added = binWeight[BINS * axis + bin];
      if (added > 0) {
        growByBin(axis, bin);
        right += added;
        rightCost[bin] = costs.partCost(right, weight) * halfArea(side);
      }
    }
  }

  private void growByBin(int axis, int bin) {
    int at = SIZE * (BINS * axis + bin);
    for (int k = 0; k < 6; k += 2) {
      side[k] = Math.min(side[k], binBox[at + k]);
      side[k + 1] = Math.max(side[k + 1], binBox[at + k + 1]);
    }
  }

  private int partition(int first, int end, int axis, int lastLeft) {
    int[] all = items;
    int low = centres[2 * axis];
    long scale = binScale(axis);
    int left = SIZE * first;
    int right = SIZE * (end - 1);
    while (true) {
      int at = 2 * axis;
      while (left <= right && bin(all[left + at] + all[left + at + 1] - low, scale) <= lastLeft) {
        left += SIZE;
      }
      while (left < right && bin(all[right + at] + all[right + at + 1] - low, scale) > lastLeft) {
        right -= SIZE;
      }
      if (left >= right) {
        return left / SIZE;
      }
      BuildItems.swap(all, left, right);
      left += SIZE;
      right -= SIZE;
    }
  }

  /** Returns the bins per unit of twice the length, times 2^32, rounded down. */
  private long binScale(int axis) {
    long length = centres[2 * axis + 1] - centres[2 * axis];
    return ((long) bins << 32) / (length + 1);
  }

  private static int bin(int distance, long scale) {
    return (int) (distance * scale >>> 32);
  }

  private static int[] emptyBins() {
    int[] boxes = new int[SIZE * BINS];
    for (int k = 0; k < boxes.length; k += 2) {
      boxes[k] = Integer.MAX_VALUE;
      boxes[k + 1] = Integer.MIN_VALUE;
    }
    return boxes;
  }

  private static void clear(int[] box) {
    System.arraycopy(EMPTY_BINS, 0, box, 0, box.length);
  }

  /** Returns half the surface area of a box that is not empty. */
  private static double halfArea(int[] box) {
    long x = box[1] - box[0];
    long y = box[3] - box[2];
    long z = box[5] - box[4];
    return x * y + y * z + z * x;
  }
}
