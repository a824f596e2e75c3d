package io.github.lumbre.stopping;

import io.github.lumbre.render.Film;
import java.util.Optional;

/**
 * How noisy a picture is, estimated from its own samples: the relative mean squared error against
 * the picture that the same render converges to, squared differences divided by the square of the
 * converged value plus 0.01, averaged over pixels and channels. Light that all samples miss, for
 * instance beyond the path length limit, is not part of the noise.
 *
 * @param relativeMse the estimate; too high for many samples of smooth pixels, since the halves
 *     that it comes from do not share the evenness of all
 * @param upperRelativeMse what the error of this picture does not exceed, with the confidence
 * @param confidence in (0,1)
 * @param tailShare the share of the estimate that the noisiest thousandth of the pixels carries,
 *     one pixel at least
 * @param pixels that the estimate comes from
 */
public record NoiseEstimate(
    double relativeMse, double upperRelativeMse, double confidence, double tailShare, long pixels) {
  /** From this share on, the estimate depends on few bright pixels. */
  private static final double HEAVY = .5;

  /**
   * Returns the estimate of a film.
   *
   * @param confidence in (0,1), of the upper bound
   * @return empty if a pixel has fewer than two samples, or earlier ones that are not known
   */
  public static Optional<NoiseEstimate> of(Film film, double confidence) {
    return NoiseEstimator.of(film, confidence);
  }

  /** Returns the root of {@link #relativeMse}. */
  public double relativeRmse() {
    return Math.sqrt(relativeMse);
  }

  /** Returns the root of {@link #upperRelativeMse}. */
  public double upperRelativeRmse() {
    return Math.sqrt(upperRelativeMse);
  }

  /** Returns the same bound, claimed with another confidence: that of all looks together. */
  NoiseEstimate claiming(double jointConfidence) {
    return new NoiseEstimate(relativeMse, upperRelativeMse, jointConfidence, tailShare, pixels);
  }

  /** Returns the same estimate with a bound of at least another one. */
  NoiseEstimate withBoundOf(double upper) {
    return new NoiseEstimate(
        relativeMse, Math.max(upperRelativeMse, upper), confidence, tailShare, pixels);
  }

  /**
   * Returns whether a thousandth of the pixels carries most of the error: more such spots may be
   * still to come, and the bound cannot know of those.
   */
  public boolean hasHeavyTail() {
    return tailShare > HEAVY && relativeMse > 0;
  }
}
