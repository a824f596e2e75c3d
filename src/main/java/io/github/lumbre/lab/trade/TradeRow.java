package io.github.lumbre.lab.trade;

import io.github.lumbre.image.Image;
import io.github.lumbre.lab.metrics.Interval;
import java.util.List;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;

/**
 * The time and error of a setting at one number of samples.
 *
 * @param seeds a picture of each seed
 * @param work work per sample
 * @param bias difference between the mean of all seeds' pictures and the reference
 */
public record TradeRow(List<TradeShot> seeds, TradeWork work, Bias bias) {
  public TradeRow {
    seeds = List.copyOf(seeds);
  }

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

  /** Returns the setting of all seeds. */
  public TradeSetting setting() {
    return seeds.get(0).setting();
  }

  /** Returns the samples per pixel of all seeds. */
  public int samples() {
    return seeds.get(0).samples();
  }

  /** Returns the picture of the first seed. */
  public Image picture() {
    return seeds.get(0).picture();
  }

  List<Double> each(Function<TradeShot, Double> value) {
    return seeds.stream().map(value).toList();
  }

  TimeToError.Cost cost() {
    return new TimeToError.Cost(
        samples(),
        each(shot -> shot.error().relativeMse()),
        each(shot -> shot.cost().cpuSeconds()));
  }

  /** Returns the number of rays and shadow rays of all samples. */
  public double allRays() {
    double pixels = (double) picture().width() * picture().height();
    return work.allRays() * samples() * pixels;
  }

  /** Returns whether every render was long enough for the CPU clock. */
  boolean isTimed() {
    return seeds.stream().allMatch(shot -> shot.cost().cpuSeconds() > 0);
  }

  /** Returns each seed's relative mean squared error × a cost. */
  List<Double> times(ToDoubleFunction<TradeShot> cost) {
    return each(shot -> Math.max(1e-30, shot.error().relativeMse() * cost.applyAsDouble(shot)));
  }

  /** Returns the mean of the seeds' relative mean squared errors. */
  public Interval relativeMse() {
    return Interval.ofMean(each(shot -> shot.error().relativeMse()));
  }

  /** Returns the mean wall-clock time. */
  public Interval time() {
    return Interval.ofMean(each(shot -> shot.cost().seconds()));
  }

  /** Returns the mean CPU time. */
  public Interval cpuTime() {
    return Interval.ofMean(each(shot -> shot.cost().cpuSeconds()));
  }

  /** Returns the mean of the seeds' mean signed errors. */
  public Interval signedError() {
    return Interval.ofMean(each(shot -> shot.error().bias()));
  }

  /** Returns the mean of the seeds' FLIP. */
  public Interval flip() {
    return Interval.ofMean(each(shot -> shot.error().flip()));
  }

  /** Returns the largest error of any seed. */
  public double largestError() {
    return seeds.stream().mapToDouble(shot -> shot.error().largest()).max().orElse(0);
  }
}
