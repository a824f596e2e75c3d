package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;

/** How one point of a surface scatters, in its local frame. Immutable, without state. */
public interface Bsdf {
  /** Returns f·|cos θi|; mirror-like (delta) lobes contribute nothing here. */
  Rgb eval(Vec3 wo, Vec3 wi);

  /** Returns the density per solid angle with which {@link #sample} draws wi, delta lobes aside. */
  double pdf(Vec3 wo, Vec3 wi);

  /**
   * Draws a direction.
   *
   * @param uLobe uniform in [0,1): chooses among lobes
   * @param u uniform in [0,1)²
   * @return {@link BsdfSample#ABSORBED} if the light ends here
   */
  BsdfSample sample(Vec3 wo, double uLobe, Point2 u);

  /** Tells whether all lobes are deltas, so that light sampling is pointless. */
  default boolean isSpecular() {
    return false;
  }

  /** Tells whether light from behind the surface may scatter to the viewer. */
  default boolean isTransmissive() {
    return false;
  }

  /** Returns the albedo of the diffuse lobe, which ambient light asks for. */
  default Rgb diffuseAlbedo() {
    return Rgb.BLACK;
  }
}
