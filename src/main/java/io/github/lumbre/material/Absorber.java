package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.SpecularBsdf;

/** A BSDF that scatters no light: the surface of a light. */
enum Absorber implements SpecularBsdf {
  BLACK;

  @Override
  public void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    result.absorb();
  }

  @Override
  public Rgb albedo() {
    return Rgb.BLACK;
  }
}
