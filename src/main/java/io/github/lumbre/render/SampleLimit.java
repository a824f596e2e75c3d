package io.github.lumbre.render;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.scene.RenderSettings;

/**
 * What becomes of a sample's radiance before it is added to the film: rejected if it is no
 * radiance, scaled down if it is brighter than the settings allow. Immutable.
 *
 * @param clamp the largest component of a sample; infinite if samples are not clamped
 */
record SampleLimit(double clamp) {
  static SampleLimit of(RenderSettings settings) {
    return new SampleLimit(settings.clamp());
  }

  /** Returns whether a sample is negative or not finite: it is added to the film as black. */
  static boolean isRejected(Rgb radiance) {
    return !radiance.isFinite() || radiance.r() < 0 || radiance.g() < 0 || radiance.b() < 0;
  }

  /** Returns whether a sample is scaled down. */
  boolean isClamped(Rgb radiance) {
    return radiance.max() > clamp && !isRejected(radiance);
  }

  /** Returns what is added to the film: the sample with its hue, or black if it is rejected. */
  Rgb apply(Rgb radiance) {
    if (isRejected(radiance)) {
      return Rgb.BLACK;
    }
    double largest = radiance.max();
    return largest > clamp ? radiance.times(clamp / largest) : radiance;
  }
}
