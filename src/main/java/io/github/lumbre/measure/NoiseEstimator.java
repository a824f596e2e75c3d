package io.github.lumbre.measure;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Elementary;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.PixelHalves;
import java.util.Optional;

/**
 * Tells a picture's noise from the difference between the halves of each pixel's samples. Mutable;
 * collects pixels, then estimates.
 *
 * <p>For halves of n1 and n2 samples with means m1 and m2, (m1 − m2)² n1 n2 / (n1 + n2)² estimates
 * the variance of the mean of all. It is unbiased for independent samples, and too high for those
 * of a scrambled net, whose halves make up for each other's errors (their covariance is negative:
 * Owen 1997, "Monte Carlo Variance of Scrambled Net Quadrature"): by (1 − ρ)/(1 + ρ), ρ being their
 * correlation, whatever the number of samples. Fixed batches would be off by a factor that grows
 * with it.
 *
 * <p>The reference's square, for the relative error, is m1 m2 without noise on average, whereas m²
 * would hide the error of bright spots in their own brightness.
 *
 * <p>Pixels are random independently of each other, so their mean is off by no more than their
 * spread over the root of their number; the same holds for the picture's own error about its
 * expectation. The bound takes both, on a logarithmic scale since the sum is skewed.
 */
final class NoiseEstimator {
  /** Below this many pixels their spread is not known well enough for a bound. */
  static final int FEWEST_PIXELS = 64;

  /** Bins of the logarithm, four for each factor of two. */
  private static final int BINS_PER_OCTAVE = 4;

  private static final int LOWEST_OCTAVE = -200;
  private static final int BINS = BINS_PER_OCTAVE * 400;

  private final long[] counts = new long[BINS];
  private final double[] sums = new double[BINS];
  private long pixels;
  private double sum;
  private double squares;

  /**
   * Returns the estimate of a film.
   *
   * @param confidence in (0,1), of the upper bound
   * @return empty if a pixel's halves are not known
   */
  static Optional<NoiseEstimate> of(Film film, double confidence) {
    NoiseEstimator estimator = new NoiseEstimator();
    int left = film.window().x();
    int top = film.window().y();
    for (int y = top; y < top + film.window().height(); y++) {
      for (int x = left; x < left + film.window().width(); x++) {
        Optional<PixelHalves> halves = film.halves(x, y);
        if (halves.isEmpty()) {
          return Optional.empty();
        }
        estimator.add(relativeError(halves.get()));
      }
    }
    return Optional.of(estimator.estimate(confidence));
  }

  /** Returns the estimate of a pixel's relative squared error, the mean over its channels. */
  static double relativeError(PixelHalves halves) {
    double all = (double) halves.firstCount() + halves.secondCount();
    double factor = halves.firstCount() / all * (halves.secondCount() / all);
    Rgb a = halves.first();
    Rgb b = halves.second();
    return factor * (relative(a.r(), b.r()) + relative(a.g(), b.g()) + relative(a.b(), b.b())) / 3;
  }

  private static double relative(double a, double b) {
    return (a - b) * (a - b) / (Math.max(0, a * b) + PictureError.FLOOR);
  }

  void add(double relativeError) {
    pixels++;
    sum += relativeError;
    squares += relativeError * relativeError;
    int bin = bin(relativeError);
    counts[bin]++;
    sums[bin] += relativeError;
  }

  private static int bin(double value) {
    if (value <= 0) {
      return 0;
    }
    double octave = Elementary.log(value) / Elementary.log(2) - LOWEST_OCTAVE;
    return (int) Math.max(0, Math.min(octave * BINS_PER_OCTAVE, BINS - 1.0));
  }

  NoiseEstimate estimate(double confidence) {
    double mean = sum / pixels;
    double upper = mean * Elementary.exp(Normal.exceeded(1 - confidence) * relativeSpread(mean));
    return new NoiseEstimate(
        mean,
        pixels < FEWEST_PIXELS ? Double.POSITIVE_INFINITY : upper,
        confidence,
        sum > 0 ? tail() / sum : 0,
        pixels);
  }

  /** Returns the standard error, as a share of the mean, of estimate and error together. */
  private double relativeSpread(double mean) {
    if (mean == 0) {
      return 0;
    }
    double variance = Math.max(0, squares / pixels - mean * mean);
    // A square of one normal number has twice its mean squared as variance; less was luck.
    double relative = Math.max(variance / (mean * mean), 2) / pixels;
    return Math.sqrt(2 * relative);
  }

  /** Returns what the noisiest thousandth of the pixels adds to the sum. */
  private double tail() {
    double left = Math.max(1, pixels / 1000);
    double tail = 0;
    for (int bin = BINS - 1; bin >= 0 && left > 0; bin--) {
      double taken = Math.min(left, counts[bin]);
      tail += counts[bin] == 0 ? 0 : sums[bin] * taken / counts[bin];
      left -= taken;
    }
    return tail;
  }
}
