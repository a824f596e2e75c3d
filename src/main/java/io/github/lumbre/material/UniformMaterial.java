package io.github.lumbre.material;

/** A material that scatters everywhere alike. */
record UniformMaterial(Bsdf bsdf) implements Material {
  @Override
  public Bsdf at(double u, double v) {
    return bsdf;
  }

  @Override
  public boolean isUniform() {
    return true;
  }

  @Override
  public Material simplified() {
    return this;
  }
}
