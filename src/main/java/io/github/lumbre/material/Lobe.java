package io.github.lumbre.material;

/** A Bsdf that can be one part of a {@link Mixture}. */
interface Lobe extends Bsdf {
  /**
   * Returns about how much of a viewer's light is scattered, at least 0: how often the lobe is
   * drawn depends on it, what is drawn does not.
   *
   * @param cosine of the angle between the viewer and the normal, negative below the surface
   */
  double importance(double cosine);

  /**
   * Draws the direction of {@link #sample}, and of delta lobes its weight; tells whether there is
   * one.
   */
  default boolean draw(BsdfSample drawn) {
    sample(drawn);
    return drawn.pdf() > 0;
  }
}
