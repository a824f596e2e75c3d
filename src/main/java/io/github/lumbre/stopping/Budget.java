package io.github.lumbre.stopping;

import io.github.lumbre.scene.RenderSettings;
import java.util.OptionalDouble;

/**
 * When a render is to end: at a number of samples or an error, whichever comes first. (A time ends
 * a render by {@link io.github.lumbre.render.Progress#isCancelled}.)
 *
 * @param samples per pixel, 1 to 2^30
 * @param targetError the relative root mean squared error to be reached, above 0; empty for none
 * @param confidence with which it is to be reached, in [.5,1)
 */
public record Budget(int samples, OptionalDouble targetError, double confidence) {
  /** The confidence of all estimates, unless another one is given. */
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

  /** Returns the budget of a fixed number of samples, with the usual confidence. */
  public static Budget ofSamples(int samples) {
    return new Budget(samples, OptionalDouble.empty(), CONFIDENCE);
  }

  /** Returns whether a picture's error is small enough, if there is a target error. */
  public boolean isReachedBy(NoiseEstimate estimate) {
    return targetError.isPresent() && estimate.upperRelativeRmse() <= targetError.getAsDouble();
  }
}
