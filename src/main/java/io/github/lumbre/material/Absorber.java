package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;

/** Scatters nothing: the surface of a lamp, as far as other light is concerned. */
enum Absorber implements Bsdf {
  BLACK;

  @Override
  public Rgb eval(Vec3 wo, Vec3 wi) {
    return Rgb.BLACK;
  }

  @Override
  public double pdf(Vec3 wo, Vec3 wi) {
    return 0;
  }

  @Override
  public BsdfSample sample(Vec3 wo, double uLobe, Point2 u) {
    return BsdfSample.ABSORBED;
  }

  @Override
  public boolean isSpecular() {
    return true;
  }
}
