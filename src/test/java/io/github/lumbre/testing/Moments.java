package io.github.lumbre.testing;

/**
 * The number, mean and variance of samples, updated one by one (Welford 1962). Mutable.
 *
 * <p>The z-tests assume that the mean is nearly normally distributed, so they reject small numbers
 * of samples. They also assume independent samples. Low-discrepancy points are not independent: use
 * the means of whole, independently scrambled sets.
 */
public final class Moments {
  /** The minimum number of samples of a z-test. */
  public static final int FEWEST = 100;

  private long count;
  private double first;
  private double mean;
  private double squares;

  public void add(double value) {
    first = count == 0 ? value : first;
    count++;
    // Far from zero, the rounding of the mean would dominate the error of the variance.
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
   * Returns the difference between the mean and a reference in standard errors. If all samples are
   * equal, the standard error is 0, and the result is 0 or infinite.
   *
   * @throws IllegalArgumentException if there are fewer than {@link #FEWEST} samples
   */
  public double z(double reference) {
    requireEnough(count);
    return ratio(mean() - reference, variance() / count);
  }

  /**
   * Returns the difference between the mean and that of other, independent samples, in standard
   * errors of the difference.
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
