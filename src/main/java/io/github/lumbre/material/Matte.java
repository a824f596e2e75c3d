package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.Texture;
import java.util.Objects;

/**
 * A diffuse surface: the format's Diffuse.
 *
 * @param albedo share of light reflected; components above 1 are taken as 1
 */
public record Matte(Texture<Rgb> albedo) implements Material {
  /** What surfaces without a material are made of. */
  public static final Matte GREY = new Matte(Texture.constant(Rgb.grey(.5)));

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
