package io.github.lumbre.render;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.scene.RenderSettings;

/**
 * The limits on a sample before it is added to the film. Invalid radiance is rejected, and radiance
 * above the settings' clamp is scaled down. Immutable.
 *
 * @param clamp the largest component of a sample; infinite if samples are not clamped
 */
record SampleLimit(double clamp) {
  static SampleLimit of(RenderSettings settings) {
    return new SampleLimit(settings.clamp());
  }

  /**
   * Returns whether a sample is negative or not finite. Such a sample is added to the film as
   * black.
   */
  static boolean isRejected(Rgb radiance) {
    return !radiance.isFinite() || radiance.r() < 0 || radiance.g() < 0 || radiance.b() < 0;
  }

  /** Returns whether a sample is scaled down. */
  boolean isClamped(Rgb radiance) {
    return radiance.max() > clamp && !isRejected(radiance);
  }

  /**
   * Returns the value to add to the film: the sample, scaled down with its hue if it is clamped, or
   * black if it is rejected.
   */
  Rgb apply(Rgb radiance) {
    if (isRejected(radiance)) {
      return Rgb.BLACK;
    }
    double largest = radiance.max();
    return largest > clamp ? radiance.times(clamp / largest) : radiance;
  }
}
