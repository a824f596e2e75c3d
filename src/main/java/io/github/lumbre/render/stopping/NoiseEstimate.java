package io.github.lumbre.render.stopping;

import io.github.lumbre.render.Film;
import java.util.Optional;

/**
 * An estimate of a picture's noise, from its own samples: the relative mean squared error against
 * the picture to which the same render converges. The error of a channel of a pixel is the squared
 * difference, divided by the square of the converged value plus 0.01; these errors are averaged
 * over pixels and channels. Light that no sample can find, for example beyond the path length
 * limit, is not part of the noise.
 *
 * @param relativeMse the estimate. For many samples of smooth pixels it is too high, because each
 *     half of the samples is less evenly distributed than all of them
 * @param upperRelativeMse upper bound of this picture's error, with the given confidence
 * @param confidence confidence of the bound, in (0,1)
 * @param outlierShare fraction of the noise that comes from outliers: pixels that a few bright
 *     samples have made several times as bright as they converge to, in [0,1]
 * @param pixels number of pixels of the estimate
 */
public record NoiseEstimate(
    double relativeMse, double upperRelativeMse, double confidence, double outlierShare, long pixels) {
  /** Above this fraction, the estimate depends on few bright samples. */
  private static final double DOUBTFUL = .25;

  /**
   * Returns the noise estimate of a film.
   *
   * @param confidence confidence of the upper bound, in (0,1)
   * @return the estimate; empty if a pixel has fewer than two samples, or if the halves of its
   *     samples are unknown
   */
  public static Optional<NoiseEstimate> of(Film film, double confidence) {
    return NoiseEstimator.of(film, confidence);
  }

  /** Returns the square root of {@link #relativeMse}. */
  public double relativeRmse() {
    return Math.sqrt(relativeMse);
  }

  /** Returns the square root of {@link #upperRelativeMse}. */
  public double upperRelativeRmse() {
    return Math.sqrt(upperRelativeMse);
  }

  /**
   * Returns the same estimate with another stated confidence: the confidence of all checks
   * together.
   */
  NoiseEstimate claiming(double jointConfidence) {
    return new NoiseEstimate(relativeMse, upperRelativeMse, jointConfidence, outlierShare, pixels);
  }

  /**
   * Returns whether more than a quarter of the noise comes from outliers. Their number and their
   * brightness are then uncertain, and the bound may not hold.
   */
  public boolean isDoubtful() {
    return outlierShare > DOUBTFUL;
  }
}
