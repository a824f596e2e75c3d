package io.github.lumbre.integrator;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.guiding.Guide;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;

/** A light transport algorithm for one scene. Immutable and shared by all threads. */
public interface Integrator {
  /** Returns the integrator that the settings select: a path tracer or a ray tracer. */
  static Integrator of(Scene scene, RenderSettings settings) {
    return of(scene, settings, Guide.NONE);
  }

  /**
   * Returns the integrator that the settings select.
   *
   * @param guide where a path tracer learned that light comes from
   */
  static Integrator of(Scene scene, RenderSettings settings, Guide guide) {
    return switch (settings.mode()) {
      case PATH -> new PathTracer(scene, PathOptions.of(settings), guide);
      case RAY ->
          new RayTracer(
              scene,
              settings.reflectionTraceDepth(),
              settings.refractionTraceDepth(),
              PathOptions.of(settings));
    };
  }

  /**
   * Returns an estimate of the radiance that arrives at the ray's origin from its direction, in
   * linear RGB.
   *
   * @param ray in world space, with a unit direction
   * @param sampler already moved to the current sample
   * @param context belongs to the calling thread
   */
  Rgb radiance(Ray ray, Sampler sampler, RenderContext context);

  /**
   * Returns the same estimate for a camera ray.
   *
   * @param ray read only
   */
  default Rgb radiance(CameraRay ray, Sampler sampler, RenderContext context) {
    return radiance(ray.toRay(), sampler, context);
  }
}
