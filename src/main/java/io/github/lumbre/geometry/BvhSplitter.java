package io.github.lumbre.geometry;

import java.util.Arrays;

/**
 * Finds where to split ranges of a builder's items, and reorders the items. Mutable; one instance
 * per thread, which works only on its own range of the shared arrays.
 */
final class BvhSplitter {
  private static final int BINS = 16;

  private final double[] boxes;
  private final int[] order;
  private final int triangles;
  private final LeafCost costs;

  /** The box of the last measured range, the box of its items' centers, and its weight. */
  private final double[] range = new double[6];

  private final double[] centres = new double[6];
  private int weight;

  // Bins for each axis.
  private final int[] binWeight = new int[3 * BINS];
  private final double[] binBox = new double[3 * BINS * 6];
  private final double[] rightCost = new double[BINS];
  private final double[] scales = new double[3];
  private final double[] side = new double[6];
  private int bins;

  BvhSplitter(double[] boxes, int[] order, int triangles, LeafCost costs) {
    this.boxes = boxes;
    this.order = order;
    this.triangles = triangles;
    this.costs = costs;
  }

  /** Returns the box of a range and selects this range for the other methods. */
  double[] measure(int first, int end) {
    clear(range, 0);
    clear(centres, 0);
    weight = 0;
    for (int i = first; i < end; i++) {
      grow(range, 0, 6 * i);
      weight += weight(i);
      for (int axis = 0; axis < 6; axis += 2) {
        double c = centre(i, axis);
        if (c < centres[axis]) {
          centres[axis] = c;
        }
        if (c > centres[axis + 1]) {
          centres[axis + 1] = c;
        }
      }
    }
    return range.clone();
  }

  /** Returns whether the measured range may become one leaf, or two leaves of different kinds. */
  boolean fitsLeaf() {
    return costs.units(weight) <= costs.maxUnits();
  }

  /** Moves triangles before shapes; returns the position of the first shape. */
  int partitionKinds(int first, int end) {
    int middle = first;
    for (int i = first; i < end; i++) {
      if (order[i] < triangles) {
        swap(i, middle++);
      }
    }
    return middle;
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
            ? halfArea(range, 0) * (costs.units(weight) - costs.nodeCost())
            : Double.POSITIVE_INFINITY;
    int bestAxis = -1;
    int bestBin = 0;
    for (int axis = 0; axis < 3; axis++) {
      fillRightCosts(axis);
      clear(side, 0);
      int left = 0;
      for (int bin = 0; bin < bins - 1; bin++) {
        if (binWeight[BINS * axis + bin] == 0) {
          continue;
        }
        growByBin(axis, bin);
        left += binWeight[BINS * axis + bin];
        double cost = costs.units(left) * halfArea(side, 0) + rightCost[bin + 1];
        if (left < weight && cost < best) {
          best = cost;
          bestAxis = axis;
          bestBin = bin;
        }
      }
    }
    return bestAxis < 0 ? first : partition(first, end, bestAxis, bestBin);
  }

  private void fillBins(int first, int end) {
    Arrays.fill(binWeight, 0);
    for (int axis = 0; axis < 3; axis++) {
      scales[axis] = binScale(axis);
      for (int bin = 0; bin < bins; bin++) {
        clear(binBox, 6 * (BINS * axis + bin));
      }
    }
    for (int i = first; i < end; i++) {
      int weight = weight(i);
      for (int axis = 0; axis < 3; axis++) {
        int bin = BINS * axis + bin(i, axis);
        binWeight[bin] += weight;
        grow(binBox, 6 * bin, 6 * i);
      }
    }
  }

  /** Sets, for each bin of an axis, the cost of a leaf that holds it and all later bins. */
  private void fillRightCosts(int axis) {
    clear(side, 0);
    int right = 0;
    for (int bin = bins - 1; bin > 0; bin--) {
      if (binWeight[BINS * axis + bin] > 0) {
        growByBin(axis, bin);
        right += binWeight[BINS * axis + bin];
      }
      rightCost[bin] = costs.units(right) * halfArea(side, 0);
    }
  }

  private void growByBin(int axis, int bin) {
    int at = 6 * (BINS * axis + bin);
    for (int k = 0; k < 6; k += 2) {
      side[k] = Math.min(side[k], binBox[at + k]);
      side[k + 1] = Math.max(side[k + 1], binBox[at + k + 1]);
    }
  }

  private int partition(int first, int end, int axis, int lastLeft) {
    int middle = first;
    for (int i = first; i < end; i++) {
      if (bin(i, axis) <= lastLeft) {
        swap(i, middle++);
      }
    }
    return middle;
  }

  /**
   * Returns the bins per unit of length. If the centers coincide, returns 0, which selects the
   * first bin for all items.
   */
  private double binScale(int axis) {
    double length = centres[2 * axis + 1] - centres[2 * axis];
    return length > 0 ? bins / length : 0;
  }

  private int bin(int i, int axis) {
    return Math.min(bins - 1, (int) ((centre(i, 2 * axis) - centres[2 * axis]) * scales[axis]));
  }

  /**
   * Returns the center of an item along an axis.
   *
   * @param at 0, 2 or 4 for x, y or z
   */
  private double centre(int i, int at) {
    return .5 * boxes[6 * i + at] + .5 * boxes[6 * i + at + 1];
  }

  private int weight(int i) {
    return costs.weight(order[i] < triangles);
  }

  private void swap(int i, int j) {
    if (i == j) {
      return;
    }
    int item = order[i];
    order[i] = order[j];
    order[j] = item;
    for (int k = 0; k < 6; k++) {
      double bound = boxes[6 * i + k];
      boxes[6 * i + k] = boxes[6 * j + k];
      boxes[6 * j + k] = bound;
    }
  }

  private static void clear(double[] box, int at) {
    for (int axis = 0; axis < 6; axis += 2) {
      box[at + axis] = Double.POSITIVE_INFINITY;
      box[at + axis + 1] = Double.NEGATIVE_INFINITY;
    }
  }

  private void grow(double[] box, int at, int by) {
    for (int axis = 0; axis < 6; axis += 2) {
      // These branches are well predicted, and so faster here than Math.min.
      if (boxes[by + axis] < box[at + axis]) {
        box[at + axis] = boxes[by + axis];
      }
      if (boxes[by + axis + 1] > box[at + axis + 1]) {
        box[at + axis + 1] = boxes[by + axis + 1];
      }
    }
  }

  /** Returns half the surface area of a box; 0 for an empty box. */
  static double halfArea(double[] box, int at) {
    double x = box[at + 1] - box[at];
    double y = box[at + 3] - box[at + 2];
    double z = box[at + 5] - box[at + 4];
    return x >= 0 ? x * y + y * z + z * x : 0;
  }
}
