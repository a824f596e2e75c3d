package io.github.lumbre.sampling;

/** A choice among n items with given weights: piecewise constant over [0,1). Immutable. */
public final class Distribution1d {
  /** The fewest items that share a part of the guide, which so takes at most a byte for each. */
  private static final int ITEMS_PER_PART = 4;

  /** cumulative[i] is the probability of items before i, cumulative[n] exactly 1. */
  private final double[] cumulative;

  /**
   * guide[k] is the item chosen by k over a power of two: the search for a number begins between
   * those of two neighbours (Chen and Asau 1974).
   */
  private final int[] guide;

  private final double mean;

  /**
   * @param weights at least one; each finite and ≥ 0; if all are 0 the choice is uniform
   */
  public Distribution1d(double... weights) {
    int n = weights.length;
    if (n == 0) {
      throw new IllegalArgumentException("weights: expected at least one, found none");
    }
    double largest = 0;
    for (double weight : weights) {
      if (!(weight >= 0) || Double.isInfinite(weight)) {
        throw new IllegalArgumentException("weights: expected finite and >= 0, found " + weight);
      }
      largest = Math.max(largest, weight);
    }
    // Relative to the largest, so that neither 1e300 nor 1e-300 leaves the range of doubles; by a
    // power of two, so that no digit changes.
    int exponent = Math.getExponent(largest);
    cumulative = new double[n + 1];
    for (int i = 0; i < n; i++) {
      cumulative[i + 1] = cumulative[i] + (largest == 0 ? 1 : Math.scalb(weights[i], -exponent));
    }
    double total = cumulative[n];
    mean = largest == 0 ? 0 : Math.scalb(total / n, exponent);
    for (int i = 1; i <= n; i++) {
      cumulative[i] = cumulative[i] == total ? 1 : cumulative[i] / total;
    }
    int parts = Integer.highestOneBit(Math.max(1, n / ITEMS_PER_PART));
    guide = new int[parts + 1];
    for (int k = 1; k < guide.length; k++) {
      guide[k] = search((double) k / parts, guide[k - 1], n - 1);
    }
  }

  public int size() {
    return cumulative.length - 1;
  }

  /** Returns the mean of the weights. */
  public double mean() {
    return mean;
  }

  /** Returns the probability of an item. */
  public double probability(int item) {
    return cumulative[item + 1] - cumulative[item];
  }

  /** Returns the item that a uniform number of [0,1) chooses; never one of probability 0. */
  public int choose(double u) {
    int part = (int) (u * (guide.length - 1));
    return search(u, guide[part], guide[part + 1]);
  }

  /** Returns the first of some items before whose end a number lies, or the last of them. */
  private int search(double u, int first, int last) {
    int low = first;
    int high = last;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (u < cumulative[middle + 1]) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return low;
  }

  /** Returns where inside the chosen item the number fell, itself uniform in [0,1). */
  public double remainder(int item, double u) {
    double r = (u - cumulative[item]) / probability(item);
    return Math.max(0, Math.min(r, 0x1.fffffffffffffp-1));
  }
}
