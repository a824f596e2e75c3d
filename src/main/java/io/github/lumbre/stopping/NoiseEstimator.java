package io.github.lumbre.stopping;

import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.PixelHalves;
import java.util.Optional;
import java.util.function.ToDoubleFunction;

/**
 * Estimates a picture's noise from the difference between the two halves of each pixel's samples.
 * Mutable: collects pixels, then estimates.
 *
 * <p>Pixels are independent random variables, so the standard error of their mean is their standard
 * deviation divided by the square root of their number. The same holds for the deviation of the
 * picture's own error from its expectation. The bound includes both, on a logarithmic scale because
 * the distribution of the sum is skewed.
 */
final class NoiseEstimator {
  /**
   * The smallest number of pixels with an error bound: with fewer, their spread is too uncertain.
   */
  static final int FEWEST_PIXELS = 64;

  /** Histogram bins per factor of two, on a logarithmic scale. */
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
   * <p>The ratio of the bound to the estimate is applied to the cautious estimate ({@link
   * PixelHalves#cautiousSquaredError}) too, and the larger of the two bounds is used. If most
   * pixels have rare bright samples, the usual estimate is too low in all of them, and their spread
   * does not show that.
   *
   * @param confidence confidence of the upper bound, in (0,1)
   * @return the estimate; empty if the halves of a pixel's samples are unknown
   */
  static Optional<NoiseEstimate> of(Film film, double confidence) {
    Optional<NoiseEstimate> cautious = cautious(film, confidence);
    return usual(film, confidence)
        .map(noise -> noise.withBoundOf(cautious.orElseThrow().relativeMse() * factor(noise)));
  }

  /**
   * Returns the estimate of a film with few samples per pixel. Its bound is at least the bound of
   * the cautious estimate, computed with that estimate's own spread.
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

  /** Returns the ratio of the upper bound to the estimate; 1 if the estimate is 0. */
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

  /**
   * Returns the standard error of the estimate and of the picture's own error together, relative to
   * the mean.
   */
  private double relativeSpread(double mean) {
    if (mean == 0) {
      return 0;
    }
    double variance = Math.max(0, squares / pixels - mean * mean);
    // The square of a normal variable has a variance of twice its squared mean. A smaller value is
    // chance.
    double relative = Math.max(variance / (mean * mean), 2) / pixels;
    return Math.sqrt(2 * relative);
  }

  /** Returns the sum over the noisiest 0.1 % of the pixels, at least one pixel. */
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
