package io.github.lumbre.lab.trade;

import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.math.internal.Elementary;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

/**
 * The cost of reaching an error with a setting. For each seed it is interpolated linearly between
 * the measured errors on logarithmic axes.
 *
 * @param samples samples per pixel, geometric mean over the seeds
 * @param cpuSeconds CPU time in seconds, geometric mean over the seeds
 * @param isExtrapolated whether a seed does not reach the error with the measured samples; beyond
 *     them the squared error is assumed inversely proportional to the samples
 */
public record TimeToError(Interval samples, Interval cpuSeconds, boolean isExtrapolated) {
  /**
   * The error and time at one number of samples: a value for each seed, in the same order in both
   * lists.
   *
   * @param samples samples per pixel
   * @param relativeMse relative mean squared errors of the pictures
   * @param cpuSeconds CPU time of all samples so far; 0 if it is too short for the CPU clock
   */
  public record Cost(int samples, List<Double> relativeMse, List<Double> cpuSeconds) {
    private static final double LEAST_SECONDS = 1e-9;

    /** Returns one seed's time, or an estimate if a time is too short for the CPU clock. */
    private double positiveSeconds(int seed, double secondsPerSample) {
      boolean isTold = cpuSeconds.stream().allMatch(seconds -> seconds > 0);
      return isTold ? cpuSeconds.get(seed) : Math.max(LEAST_SECONDS, samples * secondsPerSample);
    }
  }

  /**
   * Returns the cost of reaching an error.
   *
   * @param rows costs of one unbiased setting, by number of samples
   * @param relativeMse the error, positive
   */
  public static TimeToError of(List<Cost> rows, double relativeMse) {
    int seeds = rows.get(0).relativeMse.size();
    Cost most = rows.get(rows.size() - 1);
    double secondsPerSample = Interval.ofMean(most.cpuSeconds).value() / most.samples;
    List<Double> samples = new ArrayList<>();
    List<Double> seconds = new ArrayList<>();
    for (int i = 0; i < seeds; i++) {
      int seed = i;
      samples.add(reach(rows, seed, relativeMse, Cost::samples));
      seconds.add(
          reach(rows, seed, relativeMse, row -> row.positiveSeconds(seed, secondsPerSample)));
    }
    return new TimeToError(
        Interval.ofGeometricMean(samples),
        Interval.ofGeometricMean(seconds),
        IntStream.range(0, seeds).anyMatch(i -> !isReached(rows, i, relativeMse)));
  }

  private static boolean isReached(List<Cost> rows, int seed, double wanted) {
    return rows.stream().anyMatch(row -> row.relativeMse.get(seed) <= wanted);
  }

  /** Returns the cost, positive in all rows, at which one seed's error falls to the wanted one. */
  private static double reach(
      List<Cost> rows, int seed, double wanted, ToDoubleFunction<Cost> cost) {
    double logWanted = Elementary.log(wanted);
    Cost last = rows.get(rows.size() - 1);
    for (int i = 0; i < rows.size(); i++) {
      double error = error(rows.get(i), seed);
      if (error > logWanted) {
        continue;
      }
      if (i == 0) {
        return cost.applyAsDouble(rows.get(0)) * Elementary.exp(error - logWanted);
      }
      double before = error(rows.get(i - 1), seed);
      double share = (before - logWanted) / (before - error);
      double from = Elementary.log(cost.applyAsDouble(rows.get(i - 1)));
      double to = Elementary.log(cost.applyAsDouble(rows.get(i)));
      return Elementary.exp(from + share * (to - from));
    }
    return cost.applyAsDouble(last) * Elementary.exp(error(last, seed) - logWanted);
  }

  private static double error(Cost row, int seed) {
    return Elementary.log(row.relativeMse.get(seed));
  }
}
