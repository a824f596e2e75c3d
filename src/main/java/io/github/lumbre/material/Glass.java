package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import java.util.Objects;

/**
 * Glass, smooth or ground: the format's Refractive.
 *
 * @param reflectance tints reflections; components above 1 are taken as 1
 * @param transmittance tints what passes; components above 1 are taken as 1
 * @param ior index of refraction of the inside relative to the outside, &gt; 0
 * @param roughness α of the Trowbridge–Reitz distribution, in [0,1]; below {@link
 *     CookTorrance#SMOOTH}, or where the index is as good as 1, the surface is smooth
 */
public record Glass(
    Texture<Rgb> reflectance,
    Texture<Rgb> transmittance,
    ScalarTexture ior,
    ScalarTexture roughness)
    implements Material {
  /** Rough glass whose index is closer to 1 refracts light too little to be seen. */
  private static final double LEAST_CONTRAST = 1e-8;

  public Glass {
    Objects.requireNonNull(reflectance, "reflectance");
    Objects.requireNonNull(transmittance, "transmittance");
    Objects.requireNonNull(ior, "ior");
    Objects.requireNonNull(roughness, "roughness");
  }

  @Override
  public boolean isUniform() {
    return reflectance.isConstant()
        && transmittance.isConstant()
        && ior.isConstant()
        && roughness.isConstant();
  }

  @Override
  public Bsdf at(double u, double v) {
    Rgb reflected = reflectance.at(u, v).clampedToOne();
    Rgb passed = transmittance.at(u, v).clampedToOne();
    double index = ior.at(u, v);
    double alpha = roughness.at(u, v);
    return alpha < CookTorrance.SMOOTH || Math.abs(index - 1) < LEAST_CONTRAST
        ? new Dielectric(reflected, passed, index)
        : new RoughDielectric(reflected, passed, index, new Ggx(alpha));
  }
}
