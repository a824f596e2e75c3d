package io.github.lumbre.material;

/** Scatters nothing: the surface of a light, as other light sees it. */
enum Absorber implements SpecularBsdf {
  BLACK;

  @Override
  public void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    result.absorb();
  }
}
