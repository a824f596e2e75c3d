package io.github.lumbre.integrator;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Ray;
import io.github.lumbre.sampling.Sampler;

/** An algorithm of light transport in one scene. Immutable, shared by all threads. */
public interface Integrator {
  /**
   * Returns the radiance that arrives at the ray's origin from its direction.
   *
   * @param ray of unit direction
   * @param sampler started at the current sample
   * @param scratch the calling thread's own
   */
  Rgb radiance(Ray ray, Sampler sampler, Scratch scratch);

  /**
   * Returns the same for a ray that a camera has aimed.
   *
   * @param ray not changed here
   */
  default Rgb radiance(CameraRay ray, Sampler sampler, Scratch scratch) {
    return radiance(ray.toRay(), sampler, scratch);
  }
}
