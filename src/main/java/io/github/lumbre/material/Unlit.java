package io.github.lumbre.material;

import io.github.lumbre.texture.TexturePoint;

/** A surface that scatters nothing: of a lamp, or of anything that shows its own colour only. */
public enum Unlit implements Material {
  INSTANCE;

  @Override
  public boolean isUniform() {
    return true;
  }

  @Override
  public Bsdf at(TexturePoint point) {
    return Absorber.BLACK;
  }
}
