package io.github.lumbre.material;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;

/** A Bsdf that can be one part of a {@link Mixture}. */
interface Lobe extends Bsdf {
  /**
   * Returns about how much of the light from wo is scattered, at least 0: how often the lobe is
   * drawn depends on it, what is drawn does not.
   */
  double importance(Vec3 wo);

  /**
   * Draws the direction of {@link #sample}, and of delta lobes its weight; tells whether there is
   * one.
   */
  default boolean draw(Vec3 wo, Point2 u, BsdfSample drawn) {
    sample(wo, 0, u, drawn);
    return drawn.pdf() > 0;
  }
}
