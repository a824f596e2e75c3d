package io.github.lumbre.stopping;

import io.github.lumbre.math.Elementary;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.PixelHalves;
import java.util.Optional;
import java.util.function.ToDoubleFunction;

/**
 * Estimates a picture's noise from the difference between the halves of each pixel's samples.
 * Mutable; collects pixels, then estimates.
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
   * <p>Its bound lies above the cautious estimate ({@link PixelHalves#cautiousSquaredError}) by the
   * same factor as above the usual one. Where most pixels have rare bright samples, the usual
   * estimate is too low in all of them, and their spread does not show it.
   *
   * @param confidence in (0,1), of the upper bound
   * @return empty if a pixel's halves are not known
   */
  static Optional<NoiseEstimate> of(Film film, double confidence) {
    Optional<NoiseEstimate> cautious = cautious(film, confidence);
    return usual(film, confidence)
        .map(noise -> noise.withBoundOf(cautious.orElseThrow().relativeMse() * factor(noise)));
  }

  /**
   * Returns the estimate of a film with few samples per pixel, whose bound is that of the cautious
   * estimate, with its own spread.
   */
  static Optional<NoiseEstimate> ofFewSamples(Film film, double confidence) {
    Optional<NoiseEstimate> cautious = cautious(film, confidence);
    return usual(film, confidence)
        .map(noise -> noise.withBoundOf(cautious.orElseThrow().upperRelativeMse()));
  }

  private static Optional<NoiseEstimate> usual(Film film, double confidence) {
    return of(film, confidence, PixelHalves::relativeSquaredError);
  }

  private static Optional<NoiseEstimate> cautious(Film film, double confidence) {
    return of(film, confidence, PixelHalves::cautiousSquaredError);
  }

  /** Returns the bound over the estimate. */
  private static double factor(NoiseEstimate noise) {
    return noise.relativeMse() == 0 ? 1 : noise.upperRelativeMse() / noise.relativeMse();
  }

  private static Optional<NoiseEstimate> of(
      Film film, double confidence, ToDoubleFunction<PixelHalves> error) {
    NoiseEstimator estimator = new NoiseEstimator();
    int left = film.window().x();
    int top = film.window().y();
    for (int y = top; y < top + film.window().height(); y++) {
      for (int x = left; x < left + film.window().width(); x++) {
        Optional<PixelHalves> halves = film.halves(x, y);
        if (halves.isEmpty()) {
          return Optional.empty();
        }
        estimator.add(error.applyAsDouble(halves.get()));
      }
    }
    return Optional.of(estimator.estimate(confidence));
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
