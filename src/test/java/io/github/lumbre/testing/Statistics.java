package io.github.lumbre.testing;

import java.util.function.DoubleSupplier;

/** Significance tests of averages and correlations. */
public final class Statistics {
  /** The probability with which a correct program fails one test. */
  public static final double ALPHA = 1e-6;

  /** The two-sided critical value of z at {@link #ALPHA}. */
  public static final double CRITICAL_Z = 4.8916;

  /** The quantile of the standard normal distribution at .99, the power of our tests. */
  private static final double Z_POWER = 2.3263;

  private Statistics() {}

  /**
   * Returns the absolute value of z, for comparison with {@link #CRITICAL_Z}, and records it in the
   * figures of the run.
   */
  public static double deviation(double z) {
    Figures.worst("z", Math.abs(z));
    return Math.abs(z);
  }

  /** Returns the moments of n numbers. */
  public static Moments moments(int n, DoubleSupplier numbers) {
    Moments moments = new Moments();
    for (int i = 0; i < n; i++) {
      moments.add(numbers.getAsDouble());
    }
    return moments;
  }

  /**
   * Returns the number of samples with which a z-test detects a bias with a probability of 0.99:
   * (z_α + z_power)²(σ/δ)².
   *
   * @param bias the smallest difference to detect, in the unit of the deviation
   * @param deviation the standard deviation of one sample
   */
  public static int samplesToDetect(double bias, double deviation) {
    double root = (CRITICAL_Z + Z_POWER) * deviation / bias;
    return Math.toIntExact((long) Math.ceil(root * root));
  }

  /** Returns Pearson's correlation coefficient of pairs of numbers, in [-1, 1]. */
  public static double correlation(double[] a, double[] b) {
    if (a.length != b.length) {
      throw new IllegalArgumentException(
          "lengths: expected equal, found " + a.length + " and " + b.length);
    }
    double meanA = mean(a);
    double meanB = mean(b);
    double aa = 0;
    double bb = 0;
    double ab = 0;
    for (int i = 0; i < a.length; i++) {
      aa += (a[i] - meanA) * (a[i] - meanA);
      bb += (b[i] - meanB) * (b[i] - meanB);
      ab += (a[i] - meanA) * (b[i] - meanB);
    }
    return ab / Math.sqrt(aa * bb);
  }

  /**
   * Returns the z of the hypothesis that the pairs are uncorrelated: r·√n.
   *
   * @throws IllegalArgumentException if there are fewer than {@link Moments#FEWEST} pairs
   */
  public static double correlationZ(double[] a, double[] b) {
    Moments.requireEnough(a.length);
    return correlation(a, b) * Math.sqrt(a.length);
  }

  /**
   * Returns the slope of the straight line through points, by least squares: of log errors over log
   * counts, the order of convergence.
   */
  public static double slope(double[] x, double[] y) {
    double meanX = mean(x);
    double meanY = mean(y);
    double xx = 0;
    double xy = 0;
    for (int i = 0; i < x.length; i++) {
      xx += (x[i] - meanX) * (x[i] - meanX);
      xy += (x[i] - meanX) * (y[i] - meanY);
    }
    return xy / xx;
  }

  private static double mean(double[] values) {
    double sum = 0;
    for (double value : values) {
      sum += value;
    }
    return sum / values.length;
  }
}
