package io.github.lumbre.render;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.camera.PixelFilter;
import io.github.lumbre.math.Point2;
import io.github.lumbre.sampling.Sampler;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;

/** How a sample of a pixel starts. */
final class CameraSamples {
  private CameraSamples() {}

  /**
   * Starts a sample and aims its ray from the camera; returns false if nothing is imaged there.
   *
   * @param x of the pixel in the full frame
   * @param y of the pixel in the full frame
   */
  static boolean start(
      Scene scene,
      RenderSettings settings,
      Sampler sampler,
      int x,
      int y,
      int sample,
      CameraRay ray) {
    sampler.startSample(x, y, sample);
    Point2 jitter = sampler.get2d(Sampler.FILM);
    PixelFilter filter = settings.filter();
    double u = (x + filter.sample(jitter.x())) / settings.width();
    double v = (y + filter.sample(jitter.y())) / settings.height();
    return scene.camera().aim(u, v, sampler, ray);
  }
}
