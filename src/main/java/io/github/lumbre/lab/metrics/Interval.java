package io.github.lumbre.lab.metrics;

import io.github.lumbre.math.internal.Elementary;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;

/**
 * An estimate with its confidence interval of 95 %.
 *
 * @param low at most {@code value}
 * @param high at least {@code value}
 */
public record Interval(double value, double low, double high) {
  private static final double CONFIDENCE = .95;

  /** With n values, all lie on one side of the true median with a probability of 2^(1-n). */
  private static final int FEWEST_FOR_MEDIAN = 6;

  /** Returns the mean of independent values by Student's t; a single value has a zero interval. */
  public static Interval ofMean(List<Double> values) {
    double mean = mean(values);
    int count = values.size();
    double half =
        count < 2 ? 0 : StudentT.critical(CONFIDENCE, count - 1) * Math.sqrt(squaredError(values));
    return new Interval(mean, mean - half, mean + half);
  }

  private static double mean(List<Double> values) {
    return values.stream().mapToDouble(v -> v).sum() / values.size();
  }

  /** Returns the square of the standard error of the mean of at least two values. */
  private static double squaredError(List<Double> values) {
    double mean = mean(values);
    double squares = values.stream().mapToDouble(v -> (v - mean) * (v - mean)).sum();
    return squares / (values.size() - 1) / values.size();
  }

  /**
   * Returns the median of independent values with an interval of order statistics, as in the sign
   * test. It holds for every distribution of the values.
   *
   * @param values at least 6
   */
  public static Interval ofMedian(List<Double> values) {
    double[] sorted = values.stream().mapToDouble(v -> v).sorted().toArray();
    int count = sorted.length;
    if (count < FEWEST_FOR_MEDIAN) {
      throw new IllegalArgumentException(
          "values: expected at least " + FEWEST_FOR_MEDIAN + ", found " + count);
    }
    // The true median lies outside the interval if at most cut values are on one side of it.
    double outside = Math.scalb(1.0, -count);
    double term = outside;
    int cut = 0;
    while (2 * (outside + term * (count - cut) / (cut + 1)) <= 1 - CONFIDENCE) {
      term *= (double) (count - cut) / (cut + 1);
      outside += term;
      cut++;
    }
    double middle = .5 * (sorted[(count - 1) / 2] + sorted[count / 2]);
    return new Interval(middle, sorted[cut], sorted[count - 1 - cut]);
  }

  /** Returns the middle value, or the mean of the two in the middle; NaN without values. */
  public static double median(double... values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    int half = sorted.length / 2;
    return sorted.length == 0 ? Double.NaN : .5 * (sorted[half] + sorted[sorted.length - 1 - half]);
  }

  /** Returns the geometric mean of independent positive values, at least one. */
  public static Interval ofGeometricMean(List<Double> values) {
    return ofMean(logs(values)).exp();
  }

  private static List<Double> logs(List<Double> values) {
    return values.stream().map(Elementary::log).toList();
  }

  private Interval exp() {
    return new Interval(Elementary.exp(value), Elementary.exp(low), Elementary.exp(high));
  }

  /**
   * Returns the geometric mean of the ratios of pairs.
   *
   * @param over numerators, positive
   * @param under denominators, positive, the same number
   */
  public static Interval ofRatios(List<Double> over, List<Double> under) {
    return ofGeometricMean(
        IntStream.range(0, over.size()).mapToObj(i -> over.get(i) / under.get(i)).toList());
  }

  /**
   * Returns the ratio of the geometric means of two independent sets of times.
   *
   * <p>Times vary by factors rather than by amounts, so their logarithms are compared. Welch's t
   * test (Welch 1947, "The generalization of 'Student's' problem when several different population
   * variances are involved") needs few repetitions and no equal variances.
   *
   * @param under denominators, positive
   * @param over numerators, positive, independent of the denominators
   * @throws IllegalArgumentException if either has fewer than two times
   */
  public static Interval ofUnpairedRatio(List<Double> under, List<Double> over) {
    int fewest = Math.min(under.size(), over.size());
    if (fewest < 2) {
      throw new IllegalArgumentException("repetitions: expected at least 2, found " + fewest);
    }
    double a = squaredError(logs(under));
    double b = squaredError(logs(over));
    double half = 0;
    if (a + b > 0) {
      // The Welch-Satterthwaite equation.
      double degrees = (a + b) * (a + b) / (a * a / (under.size() - 1) + b * b / (over.size() - 1));
      half = StudentT.critical(CONFIDENCE, degrees) * Math.sqrt(a + b);
    }
    double log = mean(logs(over)) - mean(logs(under));
    return new Interval(log, log - half, log + half).exp();
  }

  /** Returns the estimate and its interval as text: {@code 0.98 (0.97 to 1.01)}. */
  public String text(int digits) {
    String number = "%." + digits + "f";
    return String.format(
        Locale.ROOT, number + " (" + number + " to " + number + ")", value, low, high);
  }
}
