package io.github.lumbre.render.stopping;

import io.github.lumbre.scene.RenderSettings;
import java.util.OptionalDouble;

/**
 * The limits that end a render: a number of samples or a target error, whichever comes first. (A
 * time limit ends a render through {@link io.github.lumbre.render.Progress#isCancelled}.)
 *
 * @param samples largest number of samples per pixel, 1 to 2^30
 * @param targetError relative root mean squared error at which to stop, above 0; empty for none
 * @param confidence confidence of the error bound, in [0.5,1)
 */
public record Budget(int samples, OptionalDouble targetError, double confidence) {
  /** The default confidence of error bounds: 95 %. */
  public static final double CONFIDENCE = .95;

  public Budget {
    require(samples >= 1 && samples <= RenderSettings.MAX_SAMPLES, "samples", samples);
    require(targetError.orElse(1) > 0, "targetError", targetError.orElse(1));
    require(confidence >= .5 && confidence < 1, "confidence", confidence);
  }

  private static void require(boolean condition, String name, double found) {
    if (!condition) {
      throw new IllegalArgumentException(name + ": out of range: " + found);
    }
  }

  /** Returns a budget of a fixed number of samples per pixel, with the default confidence. */
  public static Budget ofSamples(int samples) {
    return new Budget(samples, OptionalDouble.empty(), CONFIDENCE);
  }

  /**
   * Returns whether there is a target error, and the estimate's error bound is at most that and not
   * {@linkplain NoiseEstimate#isDoubtful doubtful}.
   */
  public boolean isReachedBy(NoiseEstimate estimate) {
    return targetError.isPresent()
        && estimate.upperRelativeRmse() <= targetError.getAsDouble()
        && !estimate.isDoubtful();
  }
}
