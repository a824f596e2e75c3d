package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;

/**
 * A smooth surface that reflects by the exact Fresnel equations and lets nothing through: the limit
 * of {@link MicrofacetReflection} without roughness, on both sides.
 *
 * @param specular tints the reflection, each component in [0,1]
 * @param ior index of refraction, &gt; 0
 */
record FresnelMirror(Rgb specular, double ior) implements SpecularBsdf, Lobe {
  @Override
  public void sample(BsdfSample drawn) {
    Vec3 wo = drawn.wo();
    Rgb weight = specular.times(Fresnel.dielectric(Math.abs(wo.z()), ior));
    drawn.setSpecular(SpecularReflection.reflect(wo), weight);
  }

  @Override
  public double importance(double cosine) {
    return specular.max() * Fresnel.dielectric(Math.abs(cosine), ior);
  }
}
