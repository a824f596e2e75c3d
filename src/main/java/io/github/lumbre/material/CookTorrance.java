package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import java.util.Objects;

/**
 * A diffuse surface under small mirrors: the format's CookTorrance.
 *
 * @param diffuse colour, scaled down with the specular one where both together exceed 1
 * @param specular colour that tints the Fresnel reflection
 * @param roughness α of the distribution, in [0,1]; below {@link #SMOOTH} a perfect mirror
 * @param ior index of refraction of the facets, &gt; 0
 */
public record CookTorrance(
    Texture<Rgb> diffuse,
    Texture<Rgb> specular,
    ScalarTexture roughness,
    ScalarTexture ior,
    MicrofacetDistribution.Kind distribution)
    implements Material {
  /** Below this roughness, facets are taken as one mirror. */
  public static final double SMOOTH = 1e-3;

  /** Index of refraction of facets that have no other. */
  public static final double DEFAULT_IOR = 3.0504;

  public CookTorrance {
    Objects.requireNonNull(diffuse, "diffuse");
    Objects.requireNonNull(specular, "specular");
    Objects.requireNonNull(roughness, "roughness");
    Objects.requireNonNull(ior, "ior");
    Objects.requireNonNull(distribution, "distribution");
  }

  @Override
  public boolean isUniform() {
    return diffuse.isConstant()
        && specular.isConstant()
        && roughness.isConstant()
        && ior.isConstant();
  }

  @Override
  public Bsdf at(double u, double v) {
    Reflectances colours = Reflectances.of(diffuse.at(u, v), specular.at(u, v));
    double alpha = roughness.at(u, v);
    double index = ior.at(u, v);
    return colours.with(
        alpha < SMOOTH
            ? new FresnelMirror(colours.specular(), index)
            : new MicrofacetReflection(
                colours.specular(), index, MicrofacetDistribution.of(distribution, alpha)));
  }
}
