package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.SpecularReflection;
import io.github.lumbre.texture.Texture;
import java.util.Objects;

/**
 * The Reflective material of the scene format: a perfect mirror.
 *
 * @param reflectance fraction of the light that is reflected; components above 1 are clamped to 1
 */
public record Mirror(Texture<Rgb> reflectance) implements Material {
  /**
   * Returns a mirror of one tint.
   *
   * @param reflectance each component in [0, 1]
   * @throws IllegalArgumentException if a component is out of range
   */
  public static Mirror of(Rgb reflectance) {
    return new Mirror(Values.reflectance("reflectance", reflectance));
  }

  public Mirror {
    Objects.requireNonNull(reflectance, "reflectance");
  }

  @Override
  public boolean isUniform() {
    return reflectance.isConstant();
  }

  @Override
  public Bsdf at(double u, double v) {
    return new SpecularReflection(reflectance.at(u, v).clampedToOne());
  }
}
