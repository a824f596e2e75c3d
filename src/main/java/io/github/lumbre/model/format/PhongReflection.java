package io.github.lumbre.model.format;

import static io.github.lumbre.material.MaterialParameter.ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.SPECULAR;
import static io.github.lumbre.material.MaterialParameter.SPECULAR_COLOR;

import io.github.lumbre.model.internal.MaterialInput;
import io.github.lumbre.model.internal.ModelMaterial;

/** The reflection of Phong materials as that of metallic-roughness materials. Stateless. */
public final class PhongReflection {
  /** The reflectance at normal incidence of index 1.5, which is the default. */
  private static final double DEFAULT_REFLECTANCE = .04;

  /** The reflectance at normal incidence of a specular color of 1. */
  private static final double FULL_REFLECTANCE = .08;

  private PhongReflection() {}

  /**
   * Returns the perceptual roughness (2 / (n + 2))^(1/4) of an exponent n, since a Beckmann
   * distribution of that roughness, α² = 2 / (n + 2), has the highlights of a Blinn-Phong exponent
   * n (Walter et al. 2007, sec. 5.2).
   */
  public static double roughness(double exponent) {
    return Math.sqrt(Math.sqrt(2 / (exponent + 2)));
  }

  /**
   * Sets a reflection of 0.08 times the specular color at normal incidence, so that the usual 0.5
   * is glass or plastic of index 1.5; or of that color, if it reflects the surroundings.
   *
   * @param color not black
   */
  public static void set(
      ModelMaterial.Builder out, MaterialInput color, boolean reflects, double exponent) {
    double scale = (reflects ? 1 : FULL_REFLECTANCE) / DEFAULT_REFLECTANCE;
    out.set(SPECULAR, 1);
    out.set(SPECULAR_COLOR, color.withFactor(color.factor().times(scale)));
    out.set(ROUGHNESS, roughness(exponent));
  }
}
