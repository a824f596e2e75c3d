package io.github.lumbre.material.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.math.Vec3;

/**
 * The BSDF of a perfect mirror, on both sides of the surface.
 *
 * @param reflectance fraction of the light that is reflected, each component in [0,1]
 */
public record SpecularReflection(Rgb reflectance) implements SpecularBsdf {
  @Override
  public void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    result.setSpecular(reflect(new Vec3(woX, woY, woZ)), reflectance);
  }

  /** Returns the direction mirrored at the normal, in the local frame. */
  public static Vec3 reflect(Vec3 wo) {
    return new Vec3(-wo.x(), -wo.y(), wo.z());
  }

  @Override
  public Rgb albedo() {
    return reflectance;
  }
}
