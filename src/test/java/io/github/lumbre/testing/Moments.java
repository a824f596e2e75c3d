package io.github.lumbre.testing;

/**
 * Number, mean and variance of samples, updated one by one (Welford 1962). Mutable.
 *
 * <p>The z-tests assume that the mean is nearly normally distributed, so they refuse few samples;
 * they know nothing of samples that depend on each other, and low-discrepancy points do: give those
 * tests means of whole, independently scrambled sets.
 */
public final class Moments {
  /** The fewest samples that a z-test takes. */
  public static final int FEWEST = 100;

  private long count;
  private double first;
  private double mean;
  private double squares;

  public void add(double value) {
    first = count == 0 ? value : first;
    count++;
    // Far from zero the rounding of the mean would be the variance's error.
    double shifted = value - first;
    double difference = shifted - mean;
    mean += difference / count;
    squares += difference * (shifted - mean);
  }

  public long count() {
    return count;
  }

  public double mean() {
    return first + mean;
  }

  /** Returns the unbiased estimate of the variance; 0 for fewer than two samples. */
  public double variance() {
    return count < 2 ? 0 : squares / (count - 1);
  }

  /**
   * Returns by how many standard errors the mean lies above a reference. Samples that are all equal
   * have a standard error of 0: then the result is 0 or infinite.
   *
   * @throws IllegalArgumentException if there are fewer than {@link #FEWEST} samples
   */
  public double z(double reference) {
    requireEnough(count);
    return ratio(mean() - reference, variance() / count);
  }

  /**
   * Returns by how many standard errors of the difference the mean lies above that of other,
   * independent samples.
   *
   * @throws IllegalArgumentException if either has fewer than {@link #FEWEST} samples
   */
  public double z(Moments other) {
    requireEnough(count);
    requireEnough(other.count);
    return ratio(mean() - other.mean(), variance() / count + other.variance() / other.count);
  }

  private static double ratio(double difference, double variance) {
    return difference == 0 ? 0 : difference / Math.sqrt(variance);
  }

  static void requireEnough(long count) {
    if (count < FEWEST) {
      throw new IllegalArgumentException(
          "samples: expected at least " + FEWEST + ", found " + count);
    }
  }
}
