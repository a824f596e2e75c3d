package io.github.lumbre.material;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import java.util.Objects;

/**
 * Smooth glass: the format's Refractive.
 *
 * @param reflectance tints reflections; components above 1 are taken as 1
 * @param transmittance tints what passes; components above 1 are taken as 1
 * @param ior index of refraction of the inside relative to the outside, &gt; 0
 */
public record Glass(Texture<Rgb> reflectance, Texture<Rgb> transmittance, ScalarTexture ior)
    implements Material {
  public Glass {
    Objects.requireNonNull(reflectance, "reflectance");
    Objects.requireNonNull(transmittance, "transmittance");
    Objects.requireNonNull(ior, "ior");
  }

  @Override
  public Bsdf at(SurfaceHit hit) {
    return new Dielectric(
        reflectance.at(hit.texture()).clampedToOne(),
        transmittance.at(hit.texture()).clampedToOne(),
        ior.at(hit.texture()));
  }
}
