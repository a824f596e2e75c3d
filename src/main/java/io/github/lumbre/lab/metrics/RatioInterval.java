package io.github.lumbre.lab.metrics;

import io.github.lumbre.math.internal.Elementary;
import java.util.List;

/**
 * The ratio of two times, with a confidence interval of 95 %.
 *
 * <p>Times vary by factors rather than by amounts, so their logarithms are compared. Welch's t test
 * (Welch 1947, "The generalization of 'Student's' problem when several different population
 * variances are involved") needs few repetitions and no equal variances. The result is the ratio of
 * the geometric means.
 *
 * @param ratio second time over first time, > 0
 * @param low lower end of the interval
 * @param high upper end of the interval
 */
public record RatioInterval(double ratio, double low, double high) {
  /** The confidence level of the interval. */
  private static final double CONFIDENCE = .95;

  /** The result of a comparison. */
  public enum Verdict {
    FASTER("faster"),
    SLOWER("slower"),
    NO_DIFFERENCE("no difference");

    private final String text;

    Verdict(String text) {
      this.text = text;
    }

    @Override
    public String toString() {
      return text;
    }
  }

  /** The mean of logarithms and the square of its standard error. */
  private record LogMean(double mean, double squaredError, int count) {
    public static LogMean of(List<Double> values) {
      int count = values.size();
      if (count < 2) {
        throw new IllegalArgumentException("repetitions: expected at least 2, found " + count);
      }
      double[] logs = values.stream().mapToDouble(Elementary::log).toArray();
      double mean = 0;
      for (double log : logs) {
        mean += log / count;
      }
      double squares = 0;
      for (double log : logs) {
        squares += (log - mean) * (log - mean);
      }
      return new LogMean(mean, squares / (count - 1) / count, count);
    }

    /** Returns this mean's term in the denominator of the Welch-Satterthwaite equation. */
    double weight() {
      return squaredError * squaredError / (count - 1);
    }
  }

  /**
   * Returns the ratio of two sets of times.
   *
   * @param first times > 0
   * @param second times > 0, independent of the first
   * @throws IllegalArgumentException if either has fewer than two times
   */
  public static RatioInterval of(List<Double> first, List<Double> second) {
    LogMean a = LogMean.of(first);
    LogMean b = LogMean.of(second);
    double difference = b.mean - a.mean;
    double squaredError = a.squaredError + b.squaredError;
    double half = 0;
    if (squaredError > 0) {
      double degrees = squaredError * squaredError / (a.weight() + b.weight());
      half = StudentT.critical(CONFIDENCE, degrees) * Math.sqrt(squaredError);
    }
    return new RatioInterval(
        Elementary.exp(difference),
        Elementary.exp(difference - half),
        Elementary.exp(difference + half));
  }

  /** Returns the verdict that the interval supports. */
  public Verdict verdict() {
    if (high < 1) {
      return Verdict.FASTER;
    }
    return low > 1 ? Verdict.SLOWER : Verdict.NO_DIFFERENCE;
  }
}
