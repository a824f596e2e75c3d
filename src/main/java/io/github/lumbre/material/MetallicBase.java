package io.github.lumbre.material;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.ChromaticGlass;
import io.github.lumbre.material.internal.ColorChannel;
import io.github.lumbre.material.internal.Dielectric;
import io.github.lumbre.material.internal.Ggx;
import io.github.lumbre.material.internal.NormalChannel;
import io.github.lumbre.material.internal.ScalarChannel;
import io.github.lumbre.material.internal.ThinFilm;
import io.github.lumbre.material.internal.ThreeColors;
import io.github.lumbre.math.Vec3;
import java.util.Optional;

/**
 * What lies below sheen and clear coat in a {@link MetallicRoughness} material: a mixture of metal,
 * plastic and glass. Immutable.
 */
final class MetallicBase {
  /** The smallest α of reflections; smoother surfaces reflect as this one. */
  static final double MIN_ALPHA = 1e-3;

  private final ColorChannel baseColor;
  private final ScalarChannel metallic;
  private final ScalarChannel roughness;
  private final ScalarChannel specular;
  private final ColorChannel specularColor;
  private final ScalarChannel transmission;
  private final ScalarChannel diffuseTransmission;
  private final ColorChannel diffuseTransmissionColor;
  private final ScalarChannel anisotropy;
  private final ScalarChannel anisotropyRotation;
  private final Optional<NormalChannel> anisotropyDirection;
  private final double ior;
  private final double dispersion;
  private final Films films;
  private final boolean isAnisotropic;
  private final boolean isTranslucent;
  private final boolean isThin;
  private final boolean isThinlyTransmissive;

  /**
   * Creates the base of a material.
   *
   * @param isThin whether glass is a thin pane, not the boundary of a volume
   */
  MetallicBase(MetallicRoughness.Builder values, boolean isThin) {
    baseColor = values.color(MaterialParameter.BASE_COLOR);
    metallic = values.number(MaterialParameter.METALLIC);
    roughness = values.number(MaterialParameter.ROUGHNESS);
    specular = values.number(MaterialParameter.SPECULAR);
    specularColor = values.color(MaterialParameter.SPECULAR_COLOR);
    transmission = values.number(MaterialParameter.TRANSMISSION);
    diffuseTransmission = values.number(MaterialParameter.DIFFUSE_TRANSMISSION);
    diffuseTransmissionColor = values.color(MaterialParameter.DIFFUSE_TRANSMISSION_COLOR);
    anisotropy = values.number(MaterialParameter.ANISOTROPY);
    anisotropyRotation = values.number(MaterialParameter.ANISOTROPY_ROTATION);
    anisotropyDirection = values.normals(MaterialParameter.ANISOTROPY_DIRECTION);
    isAnisotropic = values.states(MaterialParameter.ANISOTROPY);
    isTranslucent = values.states(MaterialParameter.DIFFUSE_TRANSMISSION);
    films = new Films(values);
    ior = values.constant(MaterialParameter.IOR);
    dispersion = isThin ? 0 : values.constant(MaterialParameter.DISPERSION);
    this.isThin = isThin;
    isThinlyTransmissive = isThin && values.states(MaterialParameter.TRANSMISSION);
  }

  /** Returns whether smooth parts may let rays pass straight through. */
  boolean isThinlyTransmissive() {
    return isThinlyTransmissive;
  }

  /** Returns whether glass refracts colors to different directions. */
  boolean isDispersive() {
    return dispersion > 0 && ior > 1;
  }

  /** Returns the square of a perceptual roughness. */
  static double alpha(ScalarChannel roughness, SurfaceHit hit) {
    double perceptual = roughness.fractionAt(hit);
    return perceptual * perceptual;
  }

  /** Returns how the surface scatters at a hit. */
  Bsdf at(SurfaceHit hit) {
    double metal = metallic.fractionAt(hit);
    double glass = glassShare(hit);
    Rgb color = baseColor(hit);
    double alpha = alpha(roughness, hit);
    if (glass == 1) {
      return glass(hit, color, alpha);
    }
    // Rounding must not make more than all of the rest a metal.
    Bsdf solid = solid(hit, color, Math.min(1, metal / (1 - glass)), alpha);
    return glass == 0 ? solid : new Blend(glass(hit, color, alpha), solid, glass);
  }

  /** Returns a mixture of metal and plastic. */
  private Bsdf solid(SurfaceHit hit, Rgb color, double metallic, double alpha) {
    Rgb f0 = dielectricF0(hit);
    double f90 = f90(hit);
    Ggx facets = new Ggx(Math.max(MIN_ALPHA, alpha));
    ThinFilm film = films.at(hit);
    if (film.strength() > 0 && metallic > 0 && metallic < 1) {
      // What the film makes of both reflections is not linear in F0.
      return new Blend(solid(hit, color, 1, alpha), solid(hit, color, 0, alpha), metallic);
    }
    double strength = isAnisotropic ? anisotropy.fractionAt(hit) : 0;
    // Schlick's approximation is linear in F0 and F90: the mean of both reflections is one lobe.
    Rgb mixedF0 = f0.times(1 - metallic).plus(color.times(metallic));
    double mixedF90 = f90 * (1 - metallic) + metallic;
    SchlickReflection isotropic = new SchlickReflection(mixedF0, mixedF90, facets, film);
    Lobe single = strength > 0 ? anisotropic(hit, isotropic, strength) : isotropic;
    Lobe reflection = compensated(single, isotropic, color, metallic, strength);
    double through = isTranslucent ? diffuseTransmission.fractionAt(hit) : 0;
    if (metallic == 1 || through == 0 && color.isBlack()) {
      return reflection;
    }
    double most = new SchlickReflection(f0, f90, facets, film).boundingF0();
    LayeredDiffuse white =
        strength > 0
            ? AnisotropicReflection.below(Rgb.WHITE, most, f90, facets.alpha(), strength)
            : new LayeredDiffuse(Rgb.WHITE, most, f90, facets.alpha());
    LayeredDiffuse reflected = white.tinted(color.times((1 - metallic) * (1 - through)));
    if (through == 0) {
      return new Mixture(reflected, reflection);
    }
    Rgb passed = diffuseTransmissionColor.at(hit).clampedToOne().times((1 - metallic) * through);
    return new Mixture(new Translucent(reflected, white.tinted(passed)), reflection);
  }

  /**
   * Returns a reflection with what its metallic part reflects repeatedly. What the plastic part
   * does not reflect reaches its diffuse base. With anisotropy, it is what isotropic facets reflect
   * repeatedly, times the ratio of the two roughnesses, which with the single reflection stays
   * below 1. AnisotropicReflectionTest scans the sum.
   */
  private static Lobe compensated(
      Lobe single, SchlickReflection isotropic, Rgb color, double metallic, double strength) {
    double alpha = isotropic.facets().alpha();
    if (metallic == 0 || alpha == MIN_ALPHA) {
      return single;
    }
    Rgb mean = SchlickReflection.meanFresnel(color, 1, isotropic.film());
    double share = metallic * (alpha / AnisotropicReflection.alphaAlong(alpha, strength));
    return new Compensated(single, MultipleScattering.reflected(mean, share, alpha));
  }

  private Lobe anisotropic(SurfaceHit hit, SchlickReflection isotropic, double strength) {
    Vec3 direction =
        anisotropyDirection
            .map(texture -> texture.map().normal(hit.u(texture.uvSet()), hit.v(texture.uvSet())))
            .orElse(Vec3.X);
    double degrees = anisotropyRotation.at(hit);
    return AnisotropicReflection.along(direction, degrees, isotropic, strength);
  }

  private Bsdf glass(SurfaceHit hit, Rgb tint, double alpha) {
    ThinFilm film = films.at(hit);
    if (isThin) {
      Rgb f0 = dielectricF0(hit);
      Ggx facets = new Ggx(Math.max(MIN_ALPHA, alpha));
      return alpha < CookTorrance.SMOOTH
          ? new SchlickReflection(f0, f90(hit), facets, film)
          : Compensated.pane(new ThinGlass(tint, f0, f90(hit), facets, film));
    }
    double index = ior == 0 ? 1e6 : Math.max(1, ior);
    boolean isSmooth = alpha < CookTorrance.SMOOTH || index - 1 < 1e-8;
    if (isDispersive() || film.strength() > 0) {
      Rgb indices = isDispersive() ? indices() : Rgb.gray(index);
      return isSmooth ? new ChromaticGlass(tint, indices, film) : rough(tint, indices, film, alpha);
    }
    return isSmooth
        ? new Dielectric(Rgb.WHITE, tint, index)
        : Compensated.glass(Rgb.WHITE, tint, index, alpha);
  }

  /** Returns rough glass; with a film, without the light that hits more than one facet. */
  private static Bsdf rough(Rgb tint, Rgb indices, ThinFilm film, double alpha) {
    return film.strength() > 0
        ? ChromaticGlass.rough(tint, indices, film, new Ggx(alpha))
        : new ThreeColors(
            Compensated.glass(Rgb.WHITE, Rgb.gray(tint.r()), indices.r(), alpha),
            Compensated.glass(Rgb.WHITE, Rgb.gray(tint.g()), indices.g(), alpha),
            Compensated.glass(Rgb.WHITE, Rgb.gray(tint.b()), indices.b(), alpha),
            Rgb.WHITE);
  }

  /**
   * Returns the index of refraction of each color: green has the stated one, and blue less red is
   * (ior - 1) / V, where V = 20 / dispersion is Abbe's number (KHR_materials_dispersion).
   */
  private Rgb indices() {
    double half = (ior - 1) * dispersion / 40;
    // With the least index, half of the digits of a refracted direction are right.
    return new Rgb(Math.max(1 + 1e-8, ior - half), ior, ior + half);
  }

  /**
   * Returns what smooth thin transmission passes; black for other surfaces.
   *
   * @param coverings sheen and clear coat, which leave a part of the light to transmission
   */
  Rgb smoothlyTransmitted(SurfaceHit hit, Coverings coverings) {
    if (!isThinlyTransmissive || alpha(roughness, hit) >= CookTorrance.SMOOTH) {
      return Rgb.BLACK;
    }
    double cosine = Math.abs(hit.wo().dot(hit.shadingNormal()));
    Rgb reflected = SchlickReflection.fresnel(dielectricF0(hit), f90(hit), films.at(hit), cosine);
    Rgb tint = baseColor(hit).times(glassShare(hit) * coverings.passed(hit, cosine));
    return ThinGlass.passed(tint, reflected);
  }

  /** Returns the fraction of the surface that transmits light. */
  private double glassShare(SurfaceHit hit) {
    return (1 - metallic.fractionAt(hit)) * transmission.fractionAt(hit);
  }

  private Rgb baseColor(SurfaceHit hit) {
    return baseColor.at(hit).clampedToOne();
  }

  private Rgb dielectricF0(SurfaceHit hit) {
    double ratio = ior == 0 ? 1 : (ior - 1) / (ior + 1);
    Rgb color = specularColor.at(hit).times(ratio * ratio);
    return color.clampedToOne().times(specular.fractionAt(hit));
  }

  private double f90(SurfaceHit hit) {
    return specular.fractionAt(hit);
  }
}
