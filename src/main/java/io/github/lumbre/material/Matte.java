package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.Texture;
import java.util.Objects;

/**
 * The Diffuse material of the scene format: an ideal diffuse reflector.
 *
 * @param albedo fraction of the light that is reflected; components above 1 are clamped to 1
 */
public record Matte(Texture<Rgb> albedo) implements Material {
  /** The default material: albedo 0.5. */
  public static final Matte GRAY = new Matte(Texture.constant(Rgb.gray(.5)));

  /**
   * Returns a matte of one color.
   *
   * @param albedo fraction of the light that is reflected, each component in [0, 1]
   * @throws IllegalArgumentException if a component is out of range
   */
  public static Matte of(Rgb albedo) {
    return new Matte(Values.reflectance("albedo", albedo));
  }

  /** Returns a matte of one color by its components, each in [0, 1]; see {@link #of(Rgb)}. */
  public static Matte of(double r, double g, double b) {
    return of(new Rgb(r, g, b));
  }

  /** Returns a matte whose color is a texture. */
  public static Matte of(Texture<Rgb> albedo) {
    return new Matte(albedo);
  }

  public Matte {
    Objects.requireNonNull(albedo, "albedo");
  }

  @Override
  public boolean isUniform() {
    return albedo.isConstant();
  }

  @Override
  public Bsdf at(double u, double v) {
    return new Lambertian(albedo.at(u, v).clampedToOne());
  }
}
