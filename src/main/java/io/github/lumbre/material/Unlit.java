package io.github.lumbre.material;

import io.github.lumbre.geometry.SurfaceHit;

/** A surface that scatters nothing: of a lamp, or of anything that shows its own colour only. */
public enum Unlit implements Material {
  INSTANCE;

  @Override
  public Bsdf at(SurfaceHit hit) {
    return Absorber.BLACK;
  }
}
