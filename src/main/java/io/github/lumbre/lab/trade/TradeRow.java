package io.github.lumbre.lab.trade;

import io.github.lumbre.image.Image;
import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.lab.metrics.PictureError;
import java.util.List;
import java.util.stream.IntStream;

/**
 * What a setting cost and how wrong it was at one number of samples: a value for each seed, in the
 * same order in all lists.
 *
 * @param samples per pixel
 * @param seconds on the wall, for all samples up to these
 * @param cpuSeconds of the process
 * @param errors against the reference
 * @param work for one sample
 * @param bias how far the mean of all seeds' pictures is from the reference
 * @param picture of the first seed
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
   * The part of the relative mean squared error that more samples do not take away: the mean over
   * pixels of ((m − r)² − s²/K − s_r²) / (r² + 0.01), m and s² being mean and variance over the K
   * seeds and s_r² the reference's own. Unbiased, so it may come out negative where there is none.
   *
   * @param squared the estimate
   * @param low end of its interval of 95 %, by the jackknife over seeds
   * @param high end of its interval, at least what was taken off for the reference: less than that
   *     cannot be told
   */
  public record Bias(double squared, double low, double high) {
    /** Tells whether the interval leaves 0 out. */
    public boolean isDetected() {
      return low > 0;
    }
  }

  /** Returns what the samples cost and bring. */
  TimeToError.Cost cost() {
    return new TimeToError.Cost(
        samples, errors.stream().map(PictureError::relativeMse).toList(), cpuSeconds);
  }

  /** Returns rays and shadow rays of all samples together. */
  public double allRays() {
    double pixels = (double) picture.width() * picture.height();
    return (work.rays() + work.shadowRays()) * samples * pixels;
  }

  /** Tells whether the processor's clock has ticked in every render. */
  boolean isTimed() {
    return cpuSeconds.stream().allMatch(time -> time > 0);
  }

  /** Returns each seed's relative mean squared error times its processor time. */
  List<Double> costs() {
    return IntStream.range(0, errors.size())
        .mapToObj(i -> Math.max(1e-30, errors.get(i).relativeMse() * cpuSeconds.get(i)))
        .toList();
  }

  /** Returns each seed's relative mean squared error times the rays of a sample. */
  List<Double> costsInRays() {
    double rays = work.rays() + work.shadowRays();
    return errors.stream().map(e -> Math.max(1e-30, e.relativeMse() * rays)).toList();
  }

  /** Returns the mean of the seeds' relative mean squared errors. */
  public Interval relativeMse() {
    return Interval.ofMean(errors.stream().map(PictureError::relativeMse).toList());
  }

  /** Returns the mean time on the wall. */
  public Interval time() {
    return Interval.ofMean(seconds);
  }

  /** Returns the mean processor time. */
  public Interval cpuTime() {
    return Interval.ofMean(cpuSeconds);
  }

  /** Returns the mean of the seeds' mean signed errors. */
  public Interval signedError() {
    return Interval.ofMean(errors.stream().map(PictureError::bias).toList());
  }

  /** Returns the mean of the seeds' FLIP. */
  public Interval flip() {
    return Interval.ofMean(errors.stream().map(PictureError::flip).toList());
  }

  /** Returns the largest error of any seed. */
  public double largestError() {
    return errors.stream().mapToDouble(PictureError::largest).max().orElse(0);
  }
}
