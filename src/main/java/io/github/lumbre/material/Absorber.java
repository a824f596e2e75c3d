package io.github.lumbre.material;

/** Scatters nothing: the surface of a lamp, as far as other light is concerned. */
enum Absorber implements SpecularBsdf {
  BLACK;

  @Override
  public void sample(BsdfSample drawn) {
    drawn.absorb();
  }
}
