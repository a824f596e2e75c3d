package io.github.lumbre.material.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Bsdf;

/** A BSDF that changes another one, and has its lobes and albedo unless it says otherwise. */
public interface BsdfAround extends Bsdf {
  /** Returns the other BSDF. */
  Bsdf bsdf();

  @Override
  default boolean choosesLobe() {
    return bsdf().choosesLobe();
  }

  @Override
  default boolean isSpecular() {
    return bsdf().isSpecular();
  }

  @Override
  default boolean isTransmissive() {
    return bsdf().isTransmissive();
  }

  @Override
  default boolean transmits() {
    return bsdf().transmits();
  }

  @Override
  default Rgb diffuseAlbedo() {
    return bsdf().diffuseAlbedo();
  }

  @Override
  default Rgb albedo() {
    return bsdf().albedo();
  }

  @Override
  default Rgb clearAlbedo() {
    return bsdf().clearAlbedo();
  }
}
