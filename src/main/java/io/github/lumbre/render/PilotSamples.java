package io.github.lumbre.render;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.integrator.RenderContext;
import io.github.lumbre.sampling.Sampler;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;

/**
 * Samples of single pixels for a pilot.
 *
 * @param scene framed for the settings
 */
record PilotSamples(RenderSettings settings, Scene scene, Integrator integrator) {
  /**
   * Returns the mean of some samples of a pixel.
   *
   * @param first number of the first sample
   * @param count number of samples, at least 1
   * @param context counts their rays
   */
  Rgb mean(int x, int y, int first, int count, Sampler sampler, RenderContext context) {
    CameraRay ray = new CameraRay();
    Rgb sum = Rgb.BLACK;
    for (int i = 0; i < count; i++) {
      context.startSample();
      if (CameraSamples.start(scene, settings, sampler, x, y, first + i, ray)) {
        Rgb radiance = integrator.radiance(ray, sampler, context);
        sum = SampleLimit.isRejected(radiance) ? sum : sum.plus(radiance);
      }
    }
    return sum.times(1. / count);
  }
}
