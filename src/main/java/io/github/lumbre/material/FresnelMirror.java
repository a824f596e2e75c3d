package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Fresnel;
import io.github.lumbre.material.internal.SpecularBsdf;
import io.github.lumbre.material.internal.SpecularReflection;
import io.github.lumbre.math.Vec3;

/**
 * A smooth surface that reflects by the exact Fresnel equations and transmits nothing, on both
 * sides. It is the limit of {@link MicrofacetReflection} for zero roughness.
 *
 * @param specular tints the reflection, each component in [0,1]
 * @param ior index of refraction, &gt; 0
 */
record FresnelMirror(Rgb specular, double ior) implements SpecularBsdf, Lobe {
  @Override
  public void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    Vec3 wo = new Vec3(woX, woY, woZ);
    Rgb weight = specular.times(Fresnel.dielectric(Math.abs(wo.z()), ior));
    result.setSpecular(SpecularReflection.reflect(wo), weight);
  }

  @Override
  public double importance(double cosine) {
    return specular.max() * Fresnel.dielectric(Math.abs(cosine), ior);
  }

  @Override
  public Rgb albedo() {
    return specular.times(Fresnel.dielectric(1, ior));
  }
}
