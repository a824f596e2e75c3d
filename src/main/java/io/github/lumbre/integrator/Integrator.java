package io.github.lumbre.integrator;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Ray;
import io.github.lumbre.sampling.Sampler;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;

/** An algorithm of light transport in one scene. Immutable, shared by all threads. */
public interface Integrator {
  /** Returns the integrator of a render with such settings. */
  static Integrator of(Scene scene, RenderSettings settings) {
    return switch (settings.mode()) {
      case PATH -> new PathTracer(scene, PathOptions.of(settings));
      case RAY ->
          new RayTracer(scene, settings.reflectionTraceDepth(), settings.refractionTraceDepth());
    };
  }

  /**
   * Returns the radiance that arrives at the ray's origin from its direction.
   *
   * @param ray of unit direction
   * @param sampler started at the current sample
   * @param context the calling thread's own
   */
  Rgb radiance(Ray ray, Sampler sampler, RenderContext context);

  /**
   * Returns the same for a ray that a camera has aimed.
   *
   * @param ray not changed here
   */
  default Rgb radiance(CameraRay ray, Sampler sampler, RenderContext context) {
    return radiance(ray.toRay(), sampler, context);
  }
}
