package io.github.lumbre.geometry;

/**
 * Finds where to split ranges of {@link BuildItems}, and reorders the items. Mutable; one instance
 * per thread, which works only on its own range of the shared items.
 *
 * <p>The first thousand items are split by the interpreter, largely. Java compiles methods that are
 * called often, so the work for each item is a method of its own.
 */
final class BvhSplitter {
  private static final int BINS = 16;

  private static final int SIZE = BuildItems.SIZE;

  /** The offset of a weight after a box, of an item as well as of a bin. */
  private static final int WEIGHT = BuildItems.WEIGHT;

  /** The empty bins of all axes. */
  private static final int[] EMPTY_BINS = emptyBins();

  private final int[] items;
  private final LeafCost costs;

  /** The box of the last measured range, and its weight. */
  private final int[] range = new int[SIZE];

  /** Minimum and maximum on x, y, z of the items' centers in that range, times two. */
  private int lowX;

  private int highX;
  private int lowY;
  private int highY;
  private int lowZ;
  private int highZ;

  /** For each axis, the bins per unit of twice the length, times 2^32, rounded down. */
  private long scaleX;

  private long scaleY;
  private long scaleZ;

  /** The boxes of each axis' bins, and their weights. */
  private final int[] bins = new int[3 * BINS * SIZE];

  /** The number of bins of each axis. */
  private int count;

  private final double[] rightCost = new double[BINS];
  private final int[] side = new int[SIZE];

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
    if (end - first == 2) {
      measurePair(SIZE * first);
      return;
    }
    count = Math.min(BINS, 2 * (end - first));
    measureCenters(first, end);
    scaleX = binScale(lowX, highX);
    scaleY = binScale(lowY, highY);
    scaleZ = binScale(lowZ, highZ);
    System.arraycopy(EMPTY_BINS, 0, bins, 0, 3 * SIZE * count);
    for (int at = SIZE * first; at < SIZE * end; at += SIZE) {
      add(at);
    }
    clear(range);
    for (int bin = 0; bin < count; bin++) {
      grow(range, SIZE * bin);
    }
  }

  private void measurePair(int at) {
    int[] all = items;
    for (int k = 0; k < 6; k += 2) {
      range[k] = Math.min(all[at + k], all[at + SIZE + k]);
      range[k + 1] = Math.max(all[at + k + 1], all[at + SIZE + k + 1]);
    }
    range[WEIGHT] = all[at + WEIGHT] + all[at + SIZE + WEIGHT];
  }

  private void measureCenters(int first, int end) {
    lowX = lowY = lowZ = Integer.MAX_VALUE;
    highX = highY = highZ = 0;
    for (int at = SIZE * first; at < SIZE * end; at += SIZE) {
      addCenter(at);
    }
  }

  private void addCenter(int at) {
    int[] all = items;
    int x = all[at] + all[at + 1];
    int y = all[at + 2] + all[at + 3];
    int z = all[at + 4] + all[at + 5];
    lowX = Math.min(lowX, x);
    highX = Math.max(highX, x);
    lowY = Math.min(lowY, y);
    highY = Math.max(highY, y);
    lowZ = Math.min(lowZ, z);
    highZ = Math.max(highZ, z);
  }

  /** Adds an item to a bin of each axis. */
  private void add(int at) {
    int[] all = items;
    int minX = all[at];
    int maxX = all[at + 1];
    int minY = all[at + 2];
    int maxY = all[at + 3];
    int minZ = all[at + 4];
    int maxZ = all[at + 5];
    int weight = all[at + WEIGHT];
    int binX = bin(minX + maxX - lowX, scaleX);
    int binY = bin(minY + maxY - lowY, scaleY) + count;
    int binZ = bin(minZ + maxZ - lowZ, scaleZ) + 2 * count;
    add(SIZE * binX, weight, minX, maxX, minY, maxY, minZ, maxZ);
    add(SIZE * binY, weight, minX, maxX, minY, maxY, minZ, maxZ);
    add(SIZE * binZ, weight, minX, maxX, minY, maxY, minZ, maxZ);
  }

  /** Adds an item, given by its weight and box, to the bin at an offset. */
  private void add(int at, int weight, int minX, int maxX, int minY, int maxY, int minZ, int maxZ) {
    int[] all = bins;
    all[at + WEIGHT] += weight;
    all[at] = Math.min(all[at], minX);
    all[at + 1] = Math.max(all[at + 1], maxX);
    all[at + 2] = Math.min(all[at + 2], minY);
    all[at + 3] = Math.max(all[at + 3], maxY);
    all[at + 4] = Math.min(all[at + 4], minZ);
    all[at + 5] = Math.max(all[at + 5], maxZ);
  }

  /** Grows a box and its weight by the bin at an offset. */
  private void grow(int[] box, int at) {
    int[] all = bins;
    box[0] = Math.min(box[0], all[at]);
    box[1] = Math.max(box[1], all[at + 1]);
    box[2] = Math.min(box[2], all[at + 2]);
    box[3] = Math.max(box[3], all[at + 3]);
    box[4] = Math.min(box[4], all[at + 4]);
    box[5] = Math.max(box[5], all[at + 5]);
    box[WEIGHT] += all[at + WEIGHT];
  }

  /** Returns the longest edge of the measured range's box. */
  int extent() {
    return Math.max(range[1] - range[0], Math.max(range[3] - range[2], range[5] - range[4]));
  }

  /** Returns whether the measured range may become one leaf, or two leaves of different kinds. */
  boolean fitsLeaf() {
    return costs.units(range[WEIGHT]) <= costs.maxUnits();
  }

  /**
   * Returns the position at which to split the reordered range. Returns {@code first} if a split is
   * impossible or does not pay.
   */
  int split(int first, int end) {
    if (end - first == 2) {
      return splitPair(first);
    }
    double best = leafCost();
    int bestAxis = -1;
    int bestBin = 0;
    for (int axis = 0; axis < 3; axis++) {
      fillRightCosts(axis);
      clear(side);
      int last = -1;
      for (int bin = 0; bin < count; bin++) {
        int at = SIZE * (count * axis + bin);
        if (bins[at + WEIGHT] == 0) {
          continue;
        }
        if (last >= 0) {
          double cost = partCost(side, 0) + rightCost[bin];
          if (cost < best) {
            best = cost;
            bestAxis = axis;
            bestBin = last;
          }
        }
        grow(side, at);
        last = bin;
      }
    }
    return bestAxis < 0 ? first : partition(first, end, bestAxis, bestBin);
  }

  /**
   * Splits two items if that pays, as bins would do: along the first axis on which their centers
   * differ. Nearly half of all ranges have two items.
   */
  private int splitPair(int first) {
    int[] all = items;
    int a = SIZE * first;
    int b = a + SIZE;
    if (partCost(all, a) + partCost(all, b) < leafCost()) {
      for (int k = 0; k < 6; k += 2) {
        int difference = all[a + k] + all[a + k + 1] - all[b + k] - all[b + k + 1];
        if (difference > 0) {
          BuildItems.swap(all, a, b);
        }
        if (difference != 0) {
          return first + 1;
        }
      }
    }
    return first;
  }

  /**
   * Returns the cost of the measured range as a leaf, less the cost of a node; infinite for none.
   */
  private double leafCost() {
    return fitsLeaf()
        ? halfArea(range, 0) * (costs.units(range[WEIGHT]) - costs.nodeCost())
        : Double.POSITIVE_INFINITY;
  }

  /** Returns the cost of a part of the measured range, given by its box and weight. */
  private double partCost(int[] array, int at) {
    return costs.partCost(array[at + WEIGHT], range[WEIGHT]) * halfArea(array, at);
  }

  /** Sets, for each bin with items of an axis, the cost of a part that holds it and later bins. */
  private void fillRightCosts(int axis) {
    clear(side);
    for (int bin = count - 1; bin > 0; bin--) {
      int at = SIZE * (count * axis + bin);
      if (bins[at + WEIGHT] > 0) {
        grow(side, at);
        rightCost[bin] = partCost(side, 0);
      }
    }
  }

  private int partition(int first, int end, int axis, int lastLeft) {
    int low = axis == 0 ? lowX : axis == 1 ? lowY : lowZ;
    long scale = axis == 0 ? scaleX : axis == 1 ? scaleY : scaleZ;
    int left = SIZE * first;
    int right = SIZE * (end - 1);
    while (true) {
      while (left <= right && bin(left + 2 * axis, low, scale) <= lastLeft) {
        left += SIZE;
      }
      while (left < right && bin(right + 2 * axis, low, scale) > lastLeft) {
        right -= SIZE;
      }
      if (left >= right) {
        return left / SIZE;
      }
      BuildItems.swap(items, left, right);
      left += SIZE;
      right -= SIZE;
    }
  }

  /** Returns the bin of an item, given the offset of its minimum along the axis. */
  private int bin(int at, int low, long scale) {
    return bin(items[at] + items[at + 1] - low, scale);
  }

  private long binScale(int low, int high) {
    long length = high - low;
    return ((long) count << 32) / (length + 1);
  }

  private static int bin(int distance, long scale) {
    return (int) (distance * scale >>> 32);
  }

  private static int[] emptyBins() {
    int[] boxes = new int[3 * SIZE * BINS];
    for (int at = 0; at < boxes.length; at += SIZE) {
      for (int k = 0; k < 6; k += 2) {
        boxes[at + k] = Integer.MAX_VALUE;
        boxes[at + k + 1] = Integer.MIN_VALUE;
      }
    }
    return boxes;
  }

  private static void clear(int[] box) {
    System.arraycopy(EMPTY_BINS, 0, box, 0, SIZE);
  }

  /** Returns half the surface area of a box at an offset, which is not empty. */
  static double halfArea(int[] array, int at) {
    long x = array[at + 1] - array[at];
    long y = array[at + 3] - array[at + 2];
    long z = array[at + 5] - array[at + 4];
    return x * y + y * z + z * x;
  }
}
