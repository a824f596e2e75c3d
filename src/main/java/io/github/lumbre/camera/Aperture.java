package io.github.lumbre.camera;

import io.github.lumbre.math.Point2;
import io.github.lumbre.sampling.Sampler;
import io.github.lumbre.sampling.Warp;

/** The form of a lens: where light may pass. */
@FunctionalInterface
public interface Aperture {
  /** The unit disc, by the concentric map. */
  Aperture DISK = sampler -> Warp.concentricDisk(sampler.get2d(Sampler.LENS));

  /**
   * Returns a uniform point of the lens, drawn at the current sample's camera dimensions: +x to the
   * camera's right, +y up, in units of the aperture.
   */
  @SuppressWarnings("exports") // internal
  Point2 sample(Sampler sampler);
}
