package io.github.lumbre.lab.trade;

import io.github.lumbre.compare.PictureError;
import io.github.lumbre.image.Image;
import io.github.lumbre.lab.metrics.Interval;
import java.util.List;
import java.util.function.Function;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;

/**
 * The time and error of a setting at one number of samples: a value for each seed, in the same
 * order in all lists.
 *
 * @param samples samples per pixel
 * @param seconds wall-clock time of all samples so far
 * @param cpuSeconds CPU time of the process
 * @param errors errors against the reference
 * @param work work per sample
 * @param bias difference between the mean of all seeds' pictures and the reference
 * @param picture picture of the first seed
 */
public record TradeRow(
    TradeSetting setting,
    int samples,
    List<Double> seconds,
    List<Double> cpuSeconds,
    List<PictureError> errors,
    TradeWork work,
    Bias bias,
    Image picture) {

  /**
   * The part of the relative mean squared error that more samples do not reduce: the mean over
   * pixels of ((m − r)² − s²/K − s_r²) / (r² + 0.01). Here m and s² are the mean and variance over
   * the K seeds, and s_r² is the variance of the reference. The estimate is unbiased, so it can be
   * negative if there is no bias.
   *
   * @param squared the estimate
   * @param low lower end of its 95 % interval, by the jackknife over seeds
   * @param high upper end of its interval, at least the reference's own squared error: a smaller
   *     bias cannot be detected
   */
  public record Bias(double squared, double low, double high) {
    /** Returns whether the interval excludes 0. */
    public boolean isDetected() {
      return low > 0;
    }
  }

  /** Returns the errors and times of the samples. */
  TimeToError.Cost cost() {
    return new TimeToError.Cost(
        samples, errors.stream().map(PictureError::relativeMse).toList(), cpuSeconds);
  }

  /** Returns the number of rays and shadow rays of all samples. */
  public double allRays() {
    double pixels = (double) picture.width() * picture.height();
    return work.allRays() * samples * pixels;
  }

  /** Returns whether every render was long enough for the CPU clock. */
  boolean isTimed() {
    return cpuSeconds.stream().allMatch(time -> time > 0);
  }

  /** Returns each seed's relative mean squared error × a cost. */
  List<Double> times(IntToDoubleFunction cost) {
    return IntStream.range(0, errors.size())
        .mapToObj(i -> Math.max(1e-30, errors.get(i).relativeMse() * cost.applyAsDouble(i)))
        .toList();
  }

  /** Returns the mean of the seeds' relative mean squared errors. */
  public Interval relativeMse() {
    return mean(PictureError::relativeMse);
  }

  private Interval mean(Function<PictureError, Double> value) {
    return Interval.ofMean(errors.stream().map(value).toList());
  }

  /** Returns the mean wall-clock time. */
  public Interval time() {
    return Interval.ofMean(seconds);
  }

  /** Returns the mean CPU time. */
  public Interval cpuTime() {
    return Interval.ofMean(cpuSeconds);
  }

  /** Returns the mean of the seeds' mean signed errors. */
  public Interval signedError() {
    return mean(PictureError::bias);
  }

  /** Returns the mean of the seeds' FLIP. */
  public Interval flip() {
    return mean(PictureError::flip);
  }

  /** Returns the largest error of any seed. */
  public double largestError() {
    return errors.stream().mapToDouble(PictureError::largest).max().orElse(0);
  }
}
