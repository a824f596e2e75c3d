package io.github.lumbre.stopping;

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
 * @param tailShare fraction of the estimate that comes from the noisiest 0.1 % of the pixels, at
 *     least one pixel
 * @param pixels number of pixels of the estimate
 */
public record NoiseEstimate(
    double relativeMse, double upperRelativeMse, double confidence, double tailShare, long pixels) {
  /** Above this fraction, the estimate depends on few bright pixels. */
  private static final double HEAVY = .5;

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
    return new NoiseEstimate(relativeMse, upperRelativeMse, jointConfidence, tailShare, pixels);
  }

  /** Returns the same estimate with an upper bound of at least the given one. */
  NoiseEstimate withBoundOf(double upper) {
    return new NoiseEstimate(
        relativeMse, Math.max(upperRelativeMse, upper), confidence, tailShare, pixels);
  }

  /** Returns the number of pixels of the tail: 0.1 % of the pixels, at least one. */
  public long tailPixels() {
    return Math.max(1, pixels / 1000);
  }

  /**
   * Returns whether more than half of the error comes from 0.1 % of the pixels. More such pixels
   * may still appear, and the bound does not account for them.
   */
  public boolean hasHeavyTail() {
    return tailShare > HEAVY && relativeMse > 0;
  }
}
