package io.github.lumbre.material;

/** A material with the same BSDF at all points. */
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
