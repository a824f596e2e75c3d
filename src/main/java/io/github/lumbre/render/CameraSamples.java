package io.github.lumbre.render;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.camera.PixelFilter;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;

/** Creates the camera rays of samples. */
final class CameraSamples {
  private CameraSamples() {}

  /**
   * Starts a sample and computes its camera ray.
   *
   * @param x the pixel's column in the full frame
   * @param y the pixel's row in the full frame
   * @param sample the number of the sample
   * @param ray receives the ray
   * @return false if the camera has no image at this film point
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
