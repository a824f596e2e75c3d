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
    int count = values.size();
    double mean = values.stream().mapToDouble(v -> v).sum() / count;
    if (count < 2) {
      return new Interval(mean, mean, mean);
    }
    double squares = values.stream().mapToDouble(v -> (v - mean) * (v - mean)).sum();
    double error = Math.sqrt(squares / (count - 1) / count);
    double half = StudentT.critical(CONFIDENCE, count - 1) * error;
    return new Interval(mean, mean - half, mean + half);
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
    Interval logs = ofMean(values.stream().map(Elementary::log).toList());
    return new Interval(
        Elementary.exp(logs.value), Elementary.exp(logs.low), Elementary.exp(logs.high));
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

  /** Returns the estimate and its interval as text: {@code 0.98 (0.97 to 1.01)}. */
  public String text(int digits) {
    String number = "%." + digits + "f";
    return String.format(
        Locale.ROOT, number + " (" + number + " to " + number + ")", value, low, high);
  }
}
