package io.github.lumbre.material;

/** Scatters nothing: the surface of a lamp, as far as other light is concerned. */
enum Absorber implements SpecularBsdf {
  BLACK;

  @Override
  public void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    result.absorb();
  }
}
