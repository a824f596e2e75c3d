package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;

/**
 * A perfect mirror on both sides.
 *
 * @param reflectance share of light reflected, each component in [0,1]
 */
public record SpecularReflection(Rgb reflectance) implements SpecularBsdf {
  @Override
  public void sample(BsdfSample drawn) {
    drawn.setSpecular(reflect(drawn.wo()), reflectance);
  }

  /** Returns the mirror direction in the local frame. */
  static Vec3 reflect(Vec3 wo) {
    return new Vec3(-wo.x(), -wo.y(), wo.z());
  }
}
