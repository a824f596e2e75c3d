package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;

/**
 * A perfect mirror on both sides.
 *
 * @param reflectance share of light reflected, each component in [0,1]
 */
public record SpecularReflection(Rgb reflectance) implements SpecularBsdf {
  @Override
  public void sample(Vec3 wo, double uLobe, Point2 u, BsdfSample drawn) {
    drawn.setSpecular(reflect(wo), reflectance);
  }

  /** Returns the mirror direction in the local frame. */
  static Vec3 reflect(Vec3 wo) {
    return new Vec3(-wo.x(), -wo.y(), wo.z());
  }
}
