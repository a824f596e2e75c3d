package io.github.lumbre.material;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;

/** Scatters nothing: the surface of a lamp, as far as other light is concerned. */
enum Absorber implements SpecularBsdf {
  BLACK;

  @Override
  public void sample(Vec3 wo, double uLobe, Point2 u, BsdfSample drawn) {
    drawn.absorb();
  }
}
