package io.github.lumbre.render;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.sampling.Sampler;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.Optional;

/** How a sample of a pixel begins, and which samples count. */
final class CameraSamples {
  private CameraSamples() {}

  /**
   * Starts a sample and returns its ray from the camera, or empty if nothing is imaged there.
   *
   * @param x of the pixel in the full frame
   * @param y likewise
   */
  static Optional<Ray> start(
      Scene scene, RenderSettings settings, Sampler sampler, int x, int y, int sample) {
    sampler.startSample(x, y, sample);
    Point2 jitter = sampler.get2d(Sampler.FILM);
    Point2 point =
        new Point2((x + jitter.x()) / settings.width(), (y + jitter.y()) / settings.height());
    return scene.camera().rayFor(point, sampler);
  }

  /** Tells whether a sample is no radiance: then it counts as black. */
  static boolean isRejected(Rgb radiance) {
    return !radiance.isFinite() || radiance.r() < 0 || radiance.g() < 0 || radiance.b() < 0;
  }
}
