package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.BsdfAround;

/**
 * A BSDF times a factor: the scattering of a partly transparent surface.
 *
 * @param factor in [0,1]
 */
record Faded(Bsdf bsdf, double factor) implements BsdfAround {
  @Override
  public void evaluate(
      double woX, double woY, double woZ, double wiX, double wiY, double wiZ, BsdfValue result) {
    bsdf.evaluate(woX, woY, woZ, wiX, wiY, wiZ, result);
    result.set(result.f().times(factor), result.pdf());
  }

  @Override
  public void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    bsdf.sample(woX, woY, woZ, uLobe, u, v, result);
    if (!result.isAbsorbed()) {
      result.set(result.wi(), result.weight().times(factor), result.pdf());
    }
  }

  @Override
  public Bsdf narrowed(Rgb throughput) {
    return new Faded(bsdf.narrowed(throughput), factor);
  }

  @Override
  public Rgb diffuseAlbedo() {
    return bsdf.diffuseAlbedo().times(factor);
  }

  @Override
  public Rgb albedo() {
    return bsdf.albedo().times(factor);
  }

  @Override
  public Rgb clearAlbedo() {
    return bsdf.clearAlbedo().times(factor);
  }
}
