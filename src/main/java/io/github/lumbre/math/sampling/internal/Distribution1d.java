package io.github.lumbre.math.sampling.internal;

/**
 * A discrete distribution: selects one of n items with probabilities proportional to their weights.
 * Immutable.
 */
public final class Distribution1d {
  /**
   * The average number of items per entry of the guide table is at least this, so that the table
   * takes at most one byte per item.
   */
  private static final int ITEMS_PER_PART = 4;

  /** cumulative[i] is the total probability of the items before i; cumulative[n] is exactly 1. */
  private final double[] cumulative;

  /**
   * The guide table of Chen and Asau (1974). With p + 1 entries, p a power of two, guide[k] is the
   * item selected by u = k / p. The search for u starts between the items of two neighboring
   * entries.
   */
  private final int[] guide;

  private final double mean;

  /**
   * Creates a distribution.
   *
   * @param weights at least one value; each finite and ≥ 0; if all are 0, the distribution is
   *     uniform
   * @throws IllegalArgumentException if there are no weights, or one is negative or not finite
   */
  public Distribution1d(double... weights) {
    int n = weights.length;
    if (n == 0) {
      throw new IllegalArgumentException("weights: expected at least one, found none");
    }
    double largest = largest(weights);
    // Scale by the largest weight, so that sums of values such as 1e300 or 1e-300 stay in the range
    // of doubles. The scale is a power of two, so that no digit changes.
    int exponent = Math.getExponent(largest);
    double scale = Math.scalb(1.0, -exponent);
    cumulative = new double[n + 1];
    double total = 0;
    for (int i = 0; i < n; i++) {
      total += largest == 0 ? 1 : weights[i] * scale;
      cumulative[i + 1] = total;
    }
    mean = largest == 0 ? 0 : Math.scalb(total / n, exponent);
    for (int i = 1; i <= n; i++) {
      cumulative[i] /= total;
    }
    guide = guide(cumulative);
  }

  public int size() {
    return cumulative.length - 1;
  }

  /** Returns the mean of the weights. */
  public double mean() {
    return mean;
  }

  public double probability(int item) {
    return cumulative[item + 1] - cumulative[item];
  }

  /** Returns the item selected by a uniform number u in [0,1); never one of probability 0. */
  public int choose(double u) {
    int part = (int) (u * (guide.length - 1));
    return search(u, guide[part], guide[part + 1]);
  }

  /**
   * Returns the first item from {@code first} to {@code last} whose cumulative end exceeds u, or
   * {@code last} if there is none.
   */
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

  /**
   * Returns the position of u within the interval of the selected item; uniform in [0,1) if u is.
   */
  public double remainder(int item, double u) {
    double r = (u - cumulative[item]) / probability(item);
    return Math.max(0, Math.min(r, 0x1.fffffffffffffp-1));
  }

  private static double largest(double... weights) {
    double largest = 0;
    for (double weight : weights) {
      if (!(weight >= 0) || weight == Double.POSITIVE_INFINITY) {
        throw new IllegalArgumentException("weights: expected finite and >= 0, found " + weight);
      }
      // A branch that is rarely taken is faster than Math.max, which waits for the one before.
      if (weight > largest) {
        largest = weight;
      }
    }
    return largest;
  }

  /** Returns the guide table; its search for all entries takes one pass over the items. */
  private static int[] guide(double... cumulative) {
    int n = cumulative.length - 1;
    int parts = Integer.highestOneBit(Math.max(1, n / ITEMS_PER_PART));
    int[] guide = new int[parts + 1];
    // Entry k is the number of items that end at k / p or before: the last such item writes it.
    for (int i = 0; i < n - 1; i++) {
      guide[(int) Math.ceil(cumulative[i + 1] * parts)] = i + 1;
    }
    for (int k = 1; k <= parts; k++) {
      guide[k] = Math.max(guide[k], guide[k - 1]);
    }
    return guide;
  }
}
