package io.github.lumbre.lab.metrics;

import io.github.lumbre.math.Elementary;
import java.util.List;

/**
 * How many times as long one thing takes as another, with a confidence interval of 95 %.
 *
 * <p>Times vary by factors rather than by amounts, so their logarithms are compared, by Welch's t
 * test (Welch 1947, "The generalization of 'Student's' problem when several different population
 * variances are involved"): it takes few repetitions and does not ask that both vary alike. What is
 * estimated is the ratio of the geometric means.
 *
 * @param ratio the second's time over the first's, > 0
 * @param low end of the interval
 * @param high end of the interval
 */
public record RatioInterval(double ratio, double low, double high) {
  /** How sure the interval is to hold the true ratio. */
  private static final double CONFIDENCE = .95;

  /** What a comparison comes to. */
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

  /** Mean of logarithms, and the square of its standard error. */
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

    /** Returns this one's part of the denominator of the Welch-Satterthwaite equation. */
    double weight() {
      return squaredError * squaredError / (count - 1);
    }
  }

  /**
   * Returns the ratio of two things' times.
   *
   * @param first times > 0
   * @param second times > 0, independent of the first
   * @throws IllegalArgumentException if there are fewer than two of either
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

  /** Returns what can be said with confidence. */
  public Verdict verdict() {
    if (high < 1) {
      return Verdict.FASTER;
    }
    return low > 1 ? Verdict.SLOWER : Verdict.NO_DIFFERENCE;
  }
}
