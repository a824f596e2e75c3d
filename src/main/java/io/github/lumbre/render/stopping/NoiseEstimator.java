package io.github.lumbre.render.stopping;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.PixelHalves;
import java.util.Optional;

/**
 * Estimates a picture's noise from the difference between the two halves of each pixel's samples.
 * Mutable: collects pixels, then estimates.
 *
 * <p>Two estimates of a pixel's error differ in the squared brightness that they divide by. The
 * first takes it from the pixel alone ({@link PixelHalves#relativeSquaredError}); a bright sample
 * that few pixels have makes it too low. The second also looks at the neighbors ({@link
 * PixelHalves#squaredErrorAmong}); a small highlight that the neighbors lack makes it too high. The
 * picture's estimate is their geometric mean, and the bound starts from the larger of this and the
 * second estimate.
 *
 * <p>Let e1 and e2 be the errors of the two halves of a pixel. The pixel's error is (e1 + e2)² / 4,
 * its estimate (e1 − e2)² / 4, and their difference e1 e2. For independent normal halves, its
 * variance is 4/3 of the expected square of the estimate, and pixels are independent of each other.
 * The bound is therefore above the estimate by the quantile of a normal distribution, on a
 * logarithmic scale because the sum over the pixels is skewed. For rare bright samples, e1 e2 varies
 * less than that: it is small unless both halves have one.
 */
final class NoiseEstimator {
  /**
   * The smallest number of pixels with an error bound: with fewer, their spread is too uncertain.
   */
  static final int FEWEST_PIXELS = 64;

  /**
   * Above this relative squared error, a pixel is an outlier: it is about {@code √10} times its
   * converged value away from it.
   */
  private static final double OUTLIER = 10;

  /**
   * With fewer samples per pixel than this, single samples weigh more, and an outlier's error must
   * be larger by the square of the ratio.
   */
  private static final double OUTLIER_SAMPLES = 32;

  /** The mean square of a variable over its squared mean, if it is the square of a normal one. */
  private static final double LEAST_SPREAD = 3;

  private long pixels;
  private double alone;
  private double among;
  private double squares;
  private double outliers;

  /**
   * Returns the estimate of a film.
   *
   * @param confidence confidence of the upper bound, in (0,1)
   * @return the estimate; empty if the halves of a pixel's samples are unknown
   */
  static Optional<NoiseEstimate> of(Film film, double confidence) {
    int top = film.window().y();
    int height = film.window().height();
    NoiseEstimator estimator = new NoiseEstimator();
    HalvesRow above = HalvesRow.NONE;
    HalvesRow row = HalvesRow.of(film, top);
    for (int y = 1; y <= height; y++) {
      HalvesRow below = y < height ? HalvesRow.of(film, top + y) : HalvesRow.NONE;
      if (!row.isKnown()) {
        return Optional.empty();
      }
      estimator.add(above, row, below);
      above = row;
      row = below;
    }
    return Optional.of(estimator.estimate(confidence));
  }

  private void add(HalvesRow above, HalvesRow row, HalvesRow below) {
    for (int x = 0; x < row.width(); x++) {
      PixelHalves halves = row.halves(x);
      double samples = (double) halves.firstCount() + halves.secondCount();
      Rgb surroundings = HalvesRow.surroundings(above, row, below, x);
      add(halves.relativeSquaredError(), halves.squaredErrorAmong(surroundings), samples);
    }
  }

  /**
   * Adds a pixel.
   *
   * @param errorAlone its error, estimated from its own samples
   * @param errorAmong its error, estimated with those of its neighbors
   * @param samples its number of samples
   */
  void add(double errorAlone, double errorAmong, double samples) {
    pixels++;
    alone += errorAlone;
    among += errorAmong;
    squares += errorAmong * errorAmong;
    double weight = Math.min(1, samples / OUTLIER_SAMPLES);
    outliers += errorAmong * weight * weight > OUTLIER ? errorAmong : 0;
  }

  NoiseEstimate estimate(double confidence) {
    double mean = Math.sqrt(alone * among) / pixels;
    double upper =
        Math.max(mean, among / pixels)
            * Elementary.exp(Normal.exceeded(1 - confidence) * relativeSpread());
    return new NoiseEstimate(
        mean,
        pixels < FEWEST_PIXELS ? Double.POSITIVE_INFINITY : upper,
        confidence,
        outliers > 0 ? outliers / among : 0,
        pixels);
  }

  /** Returns the standard deviation of the picture's error about its estimate, relative to it. */
  private double relativeSpread() {
    if (among == 0) {
      return 0;
    }
    // A smaller value than that of equally noisy pixels is chance.
    double square = Math.max(squares / among * (pixels / among), LEAST_SPREAD);
    return Math.sqrt(4 / 3.0 * square / pixels);
  }
}
