package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;

/**
 * Diffuse reflection, and diffuse transmission to the other side of the surface, below dielectric
 * layers on both sides (KHR_materials_diffuse_transmission). The transmitted light has the
 * distribution of a diffuse reflection, mirrored at the surface. Symmetric in both directions; no
 * factor depends on an index of refraction.
 *
 * @param reflection of light from the viewer's side
 * @param transmission as the reflection of light from the mirror image of its direction; the sum of
 *     both albedos is at most 1 in each component
 */
record Translucent(LayeredDiffuse reflection, LayeredDiffuse transmission) implements Lobe {
  /** The largest random number. */
  private static final double BELOW_ONE = 0x1.fffffffffffffp-1;

  /** Returns the probability of sampling the reflection. */
  private double share() {
    double reflected = reflection.albedo().max();
    double sum = reflected + transmission.albedo().max();
    return sum > 0 ? reflected / sum : 1;
  }

  @Override
  public boolean isTransmissive() {
    return true;
  }

  @Override
  public void evaluate(
      double woX, double woY, double woZ, double wiX, double wiY, double wiZ, BsdfValue result) {
    boolean reflects = woZ * wiZ > 0;
    LayeredDiffuse lobe = reflects ? reflection : transmission;
    lobe.evaluate(woX, woY, woZ, wiX, wiY, reflects ? wiZ : -wiZ, result);
    double share = share();
    result.set(result.f(), result.pdf() * (reflects ? share : 1 - share));
  }

  @Override
  public boolean draw(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    double share = share();
    if (u < share) {
      return reflection.draw(woX, woY, woZ, uLobe, u / share, v, result);
    }
    // What is left of the random number is uniform again.
    double uRest = Math.min(BELOW_ONE, (u - share) / (1 - share));
    boolean isDrawn = transmission.draw(woX, woY, woZ, uLobe, uRest, v, result);
    result.setDirection(result.x(), result.y(), -result.z());
    return isDrawn;
  }

  @Override
  public double importance(double cosine) {
    return reflection.importance(cosine) + transmission.importance(cosine);
  }

  @Override
  public Rgb diffuseAlbedo() {
    return albedo();
  }

  @Override
  public Rgb albedo() {
    return reflection.albedo().plus(transmission.albedo());
  }
}
