package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Microfacets;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import java.util.Objects;

/**
 * The CookTorrance material of the scene format: a diffuse lobe plus microfacet reflection.
 *
 * @param diffuse diffuse color; both colors are scaled down wherever their sum exceeds 1
 * @param specular color that tints the Fresnel reflection
 * @param roughness α of the distribution, in [0,1]; below {@link #SMOOTH} the surface is a perfect
 *     mirror
 * @param ior index of refraction of the facets, &gt; 0
 * @param distribution distribution of the microfacet normals
 * @param multipleScattering whether light that hits more than one facet is scattered, not lost; the
 *     distribution must be GGX
 */
public record CookTorrance(
    Texture<Rgb> diffuse,
    Texture<Rgb> specular,
    ScalarTexture roughness,
    ScalarTexture ior,
    MicrofacetDistribution distribution,
    boolean multipleScattering)
    implements Material {
  /** Below this roughness α, a surface is treated as perfectly smooth. */
  public static final double SMOOTH = 1e-3;

  /** Default index of refraction of the facets. */
  public static final double DEFAULT_IOR = 3.0504;

  /**
   * Returns a material of two colors, with the default index of refraction and GGX facets.
   *
   * @param diffuse each component in [0, 1]
   * @param specular each component in [0, 1]
   * @param roughness α, in [0, 1]
   * @throws IllegalArgumentException if a number is out of range
   */
  public static CookTorrance of(Rgb diffuse, Rgb specular, double roughness) {
    return new CookTorrance(
        Values.reflectance("diffuse", diffuse),
        Values.reflectance("specular", specular),
        Values.number("roughness", roughness, Range.FRACTION),
        ScalarTexture.constant(DEFAULT_IOR),
        MicrofacetDistribution.GGX);
  }

  /** Creates a material that loses the light that hits more than one facet. */
  public CookTorrance(
      Texture<Rgb> diffuse,
      Texture<Rgb> specular,
      ScalarTexture roughness,
      ScalarTexture ior,
      MicrofacetDistribution distribution) {
    this(diffuse, specular, roughness, ior, distribution, false);
  }

  /**
   * Creates a material.
   *
   * @throws IllegalArgumentException if light that hits more than one facet is scattered, and the
   *     distribution is not GGX
   */
  public CookTorrance {
    Objects.requireNonNull(diffuse, "diffuse");
    Objects.requireNonNull(specular, "specular");
    Objects.requireNonNull(roughness, "roughness");
    Objects.requireNonNull(ior, "ior");
    Objects.requireNonNull(distribution, "distribution");
    if (multipleScattering && distribution != MicrofacetDistribution.GGX) {
      throw new IllegalArgumentException(
          "multipleScattering: expected the distribution GGX, found " + distribution);
    }
  }

  /** Returns this material with the light that hits more than one facet, which must be GGX's. */
  public CookTorrance withMultipleScattering() {
    return new CookTorrance(diffuse, specular, roughness, ior, distribution, true);
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
    Reflectances colors = Reflectances.of(diffuse.at(u, v), specular.at(u, v));
    double alpha = roughness.at(u, v);
    double index = ior.at(u, v);
    return colors.with(
        alpha < SMOOTH
            ? new FresnelMirror(colors.specular(), index)
            : rough(colors.specular(), index, alpha));
  }

  private Lobe rough(Rgb color, double index, double alpha) {
    Lobe single = new MicrofacetReflection(color, index, Microfacets.of(distribution, alpha));
    if (!multipleScattering) {
      return single;
    }
    Rgb mean = color.times(MultipleScattering.meanReflectance(index));
    return new Compensated(single, MultipleScattering.reflected(mean, 1, alpha));
  }
}
