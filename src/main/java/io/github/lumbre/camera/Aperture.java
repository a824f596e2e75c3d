package io.github.lumbre.camera;

import io.github.lumbre.math.Point2;
import io.github.lumbre.sampling.Sampler;
import io.github.lumbre.sampling.Warp;

/** The shape of a lens aperture, from which lens points are sampled. */
@FunctionalInterface
public interface Aperture {
  /** The unit disk, sampled with the concentric map. */
  Aperture DISK = sampler -> Warp.concentricDisk(sampler.get2d(Sampler.LENS));

  /**
   * Samples a uniform point of the lens with the camera dimensions of the current sample. In the
   * result, +x points to the camera's right and +y up, in units of the aperture.
   */
  @SuppressWarnings("exports") // internal
  Point2 sample(Sampler sampler);
}
