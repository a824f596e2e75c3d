package io.github.lumbre.render.denoise;

import io.github.lumbre.image.Image;
import java.util.OptionalDouble;

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

  /**
   * Makes a denoised picture.
   *
   * @param before the {@link #noise} of the picture
   */
  static Denoised of(
      NoisyPicture noisy,
      float[] light,
      String engine,
      OptionalDouble before,
      OptionalDouble error) {
    double change = relative(light, 1, noisy.light().mean());
    return new Denoised(noisy.withLight(light), engine, change, before, error);
  }

  /** Returns the noise of a picture, relative to its denoised light, if it is known. */
  static OptionalDouble noise(NoisyPicture noisy, float[] light) {
    return noisy.light().isNoiseKnown()
        ? OptionalDouble.of(relative(light, 0, noisy.light().noise()))
        : OptionalDouble.empty();
  }

  /**
   * Returns the root of the mean of squared differences, each divided by squared light + 0.01. They
   * are those of a factor times light to other values.
   */
  private static double relative(float[] light, double factor, float[] others) {
    double sum = 0;
    for (int i = 0; i < light.length; i++) {
      double value = light[i];
      double difference = factor * value - others[i];
      sum += difference * difference / (value * value + FLOOR);
    }
    return Math.sqrt(sum / light.length);
  }
}
