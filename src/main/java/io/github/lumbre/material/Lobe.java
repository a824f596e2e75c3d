package io.github.lumbre.material;

import io.github.lumbre.math.Vec3;

/**
 * A BSDF that can be one of the two lobes of a {@link Mixture}. It implements {@link #draw} or
 * {@link #sample}; each has a default that uses the other.
 */
interface Lobe extends Bsdf {
  /**
   * Returns an estimate, at least 0, of the fraction of light that the lobe scatters. It determines
   * how often the lobe is sampled and does not bias the result.
   *
   * @param cosine cosine of the angle between the viewer's direction and the normal, negative below
   *     the surface
   */
  double importance(double cosine);

  /**
   * Samples a direction as {@link #sample} does. Only delta lobes must also set the weight. Returns
   * whether a direction was sampled.
   */
  default boolean draw(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    sample(woX, woY, woZ, uLobe, u, v, result);
    return result.pdf() > 0;
  }

  @Override
  default void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    if (draw(woX, woY, woZ, uLobe, u, v, result)) {
      result.weighBy(this, new Vec3(woX, woY, woZ));
    } else {
      result.absorb();
    }
  }
}
