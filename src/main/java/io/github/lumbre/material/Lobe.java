package io.github.lumbre.material;

/** A Bsdf that can be one part of a {@link Mixture}. */
interface Lobe extends Bsdf {
  /**
   * Returns about how much of a viewer's light is scattered, at least 0: it affects how often the
   * lobe is sampled, not the result.
   *
   * @param cosine of the angle between the viewer and the normal, negative below the surface
   */
  double importance(double cosine);

  /**
   * Samples the direction as {@link #sample} does, and of delta lobes the weight too. Returns
   * whether there is a direction.
   */
  default boolean draw(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    sample(woX, woY, woZ, uLobe, u, v, result);
    return result.pdf() > 0;
  }
}
