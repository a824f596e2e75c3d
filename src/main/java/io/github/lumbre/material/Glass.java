package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Dielectric;
import io.github.lumbre.material.internal.Ggx;
import io.github.lumbre.material.internal.RoughDielectric;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import java.util.Objects;

/**
 * The Refractive material of the scene format: smooth or rough glass.
 *
 * @param reflectance tints the reflected light; components above 1 are clamped to 1
 * @param transmittance tints the refracted light; components above 1 are clamped to 1
 * @param ior index of refraction of the inside relative to the outside, &gt; 0
 * @param roughness α of the Trowbridge–Reitz distribution, in [0,1]; below {@link
 *     CookTorrance#SMOOTH}, or where the index differs from 1 by less than 1e-8, the surface is
 *     smooth
 * @param multipleScattering whether light that hits more than one facet is scattered, not lost
 */
public record Glass(
    Texture<Rgb> reflectance,
    Texture<Rgb> transmittance,
    ScalarTexture ior,
    ScalarTexture roughness,
    boolean multipleScattering)
    implements Material {
  /** Rough glass whose index is closer to 1 than this bends light too little to be visible. */
  private static final double LEAST_CONTRAST = 1e-8;

  /**
   * Returns clear, smooth glass.
   *
   * @param ior index of refraction, above 0, to 1e6; 1.5 for window glass
   * @throws IllegalArgumentException if the index is out of range
   */
  public static Glass of(double ior) {
    return of(ior, Rgb.WHITE);
  }

  /**
   * Returns smooth glass that tints what it transmits at each surface.
   *
   * @param transmittance each component in [0, 1]
   * @throws IllegalArgumentException if a number is out of range
   */
  public static Glass of(double ior, Rgb transmittance) {
    return new Glass(
        Texture.constant(Rgb.WHITE),
        Values.reflectance("transmittance", transmittance),
        Values.number("ior", ior, Dielectric.IOR),
        ScalarTexture.constant(0));
  }

  /**
   * Returns this glass with a rough surface.
   *
   * @param alpha α of the Trowbridge–Reitz distribution, in [0, 1]
   * @throws IllegalArgumentException if the roughness is out of range
   */
  public Glass withRoughness(double alpha) {
    ScalarTexture rough = Values.number("roughness", alpha, Range.FRACTION);
    return new Glass(reflectance, transmittance, ior, rough, multipleScattering);
  }

  /** Returns this glass with the light that hits more than one facet. */
  public Glass withMultipleScattering() {
    return new Glass(reflectance, transmittance, ior, roughness, true);
  }

  /** Creates glass that loses the light that hits more than one facet. */
  public Glass(
      Texture<Rgb> reflectance,
      Texture<Rgb> transmittance,
      ScalarTexture ior,
      ScalarTexture roughness) {
    this(reflectance, transmittance, ior, roughness, false);
  }

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
    if (alpha < CookTorrance.SMOOTH || Math.abs(index - 1) < LEAST_CONTRAST) {
      return new Dielectric(reflected, passed, index);
    }
    return multipleScattering
        ? Compensated.glass(reflected, passed, index, alpha)
        : new RoughDielectric(reflected, passed, index, new Ggx(alpha));
  }
}
