package io.github.lumbre.material;

import io.github.lumbre.math.Vec3;

/** A Bsdf of delta lobes alone: directions can be drawn from it, but none hits it by chance. */
interface SpecularBsdf extends Bsdf {
  @Override
  default void evaluate(
      double woX, double woY, double woZ, double wiX, double wiY, double wiZ, BsdfValue result) {
    result.clear();
  }

  @Override
  default double pdf(Vec3 wo, Vec3 wi) {
    return 0;
  }

  @Override
  default boolean isSpecular() {
    return true;
  }
}
