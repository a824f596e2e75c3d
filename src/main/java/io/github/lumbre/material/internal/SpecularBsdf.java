package io.github.lumbre.material.internal;

import io.github.lumbre.material.Bsdf;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.math.Vec3;

/**
 * A BSDF with only delta lobes: it can be sampled, but its value and density for given directions
 * are 0.
 */
public interface SpecularBsdf extends Bsdf {
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
