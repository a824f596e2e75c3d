package io.github.lumbre.measure;

import java.util.List;

/**
 * A value and an interval that holds the true one with a confidence of 95 %.
 *
 * @param low at most {@code value}
 * @param high at least {@code value}
 */
public record Interval(double value, double low, double high) {
  private static final double CONFIDENCE = .95;

  /** Returns the mean of independent values, at least one, by Student's t; of one, itself. */
  public static Interval ofMean(List<Double> values) {
    int count = values.size();
    double mean = values.stream().mapToDouble(v -> v).sum() / count;
    if (count < 2) {
      return new Interval(mean, mean, mean);
    }
    double squares = values.stream().mapToDouble(v -> (v - mean) * (v - mean)).sum();
    double half =
        StudentT.critical(CONFIDENCE, count - 1) * Math.sqrt(squares / (count - 1) / count);
    return new Interval(mean, mean - half, mean + half);
  }
}
