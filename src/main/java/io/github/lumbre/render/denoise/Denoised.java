package io.github.lumbre.render.denoise;

import io.github.lumbre.image.Image;
import java.util.OptionalDouble;
import java.util.function.IntToDoubleFunction;

/**
 * A picture after denoising.
 *
 * @param image the picture
 * @param engine the denoiser: {@code builtin} and the start of the SHA-256 hash of its weights, or
 *     an outside program with its version
 * @param change how much the denoiser changed the picture: root of the mean of (denoised -
 *     noisy)²/(denoised² + 0.01) over pixels and channels
 * @param relativeNoise the noise before, as the halves of the samples show it: root of the mean of
 *     noise²/(denoised² + 0.01); empty if it is not known
 * @param relativeError the denoiser's own estimate of the relative RMSE that is left: root of the
 *     mean of squared errors divided by squared light + 0.01; empty if it makes none. It is an
 *     estimate, not a bound, and not comparable with the noise estimate of a render, which is made
 *     in another way: it may be the larger one although the error is the smaller one.
 */
public record Denoised(
    Image image,
    String engine,
    double change,
    OptionalDouble relativeNoise,
    OptionalDouble relativeError) {
  /** Keeps dark pixels from dominating; in units of squared light. */
  static final double FLOOR = .01;

  static Denoised of(NoisyPicture noisy, float[] light, String engine, OptionalDouble error) {
    float[] mean = noisy.light().mean();
    double change = relative(light, i -> light[i] - (double) mean[i]);
    OptionalDouble before =
        noisy.light().isNoiseKnown()
            ? OptionalDouble.of(relative(light, i -> noisy.light().noise()[i]))
            : OptionalDouble.empty();
    return new Denoised(noisy.withLight(light), engine, change, before, error);
  }

  /** Returns the root of the mean of squared differences, each divided by squared light + 0.01. */
  static double relative(float[] light, IntToDoubleFunction differences) {
    double sum = 0;
    for (int i = 0; i < light.length; i++) {
      double difference = differences.applyAsDouble(i);
      sum += difference * difference / ((double) light[i] * light[i] + FLOOR);
    }
    return Math.sqrt(sum / light.length);
  }
}
