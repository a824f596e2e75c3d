package io.github.lumbre.material;

import io.github.lumbre.texture.TexturePoint;

/** A material that scatters everywhere alike. */
record UniformMaterial(Bsdf bsdf) implements Material {
  @Override
  public Bsdf at(TexturePoint point) {
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
