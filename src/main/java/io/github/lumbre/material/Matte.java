package io.github.lumbre.material;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.Constant;
import io.github.lumbre.texture.Texture;
import java.util.Objects;

/** A diffuse surface: the format's Diffuse. */
public final class Matte implements Material {
  /** What surfaces without a material are made of. */
  public static final Matte GREY = new Matte(Texture.constant(Rgb.grey(.5)));

  private final Texture<Rgb> albedo;
  private final Lambertian constant;

  /**
   * @param albedo share of light reflected; components above 1 are taken as 1
   */
  public Matte(Texture<Rgb> albedo) {
    this.albedo = Objects.requireNonNull(albedo, "albedo");
    constant = albedo instanceof Constant<Rgb> c ? new Lambertian(c.value().clampedToOne()) : null;
  }

  @Override
  public Bsdf at(SurfaceHit hit) {
    return constant != null ? constant : new Lambertian(albedo.at(hit.texture()).clampedToOne());
  }
}
