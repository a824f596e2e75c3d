package io.github.lumbre.material;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.ColorChannel;
import io.github.lumbre.material.internal.Dielectric;
import io.github.lumbre.material.internal.Ggx;
import io.github.lumbre.material.internal.NormalChannel;
import io.github.lumbre.material.internal.RoughDielectric;
import io.github.lumbre.material.internal.ScalarChannel;
import io.github.lumbre.material.internal.Tilted;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.texture.TexturePoint;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;

/**
 * The metallic-roughness material of glTF 2.0, Appendix B, with the layers of the {@code
 * KHR_materials_} extensions: specular, ior, transmission, volume, clearcoat and sheen.
 *
 * <p>The lobes are those of the specification. Unlike there, a layer's albedo weights what lies
 * below it, so that the material is reciprocal and never reflects more light than arrives. Smooth
 * thin transmission and partial opacity let rays pass straight through; see {@link #transmittance}.
 *
 * <p>Immutable; {@link #builder} builds it.
 */
public final class MetallicRoughness implements Material {
  /** The smallest α of reflections; smoother surfaces reflect as this one. */
  private static final double MIN_ALPHA = 1e-3;

  /** The reflectance of the clear coat at normal incidence, for an index of refraction of 1.5. */
  private static final double COAT_F0 = .04;

  private static final TexturePoint ORIGIN = new TexturePoint(0, 0);

  private final Map<MaterialParameter, Channel> stated;
  private final ColorChannel baseColor;
  private final ScalarChannel opacity;
  private final ScalarChannel metallic;
  private final ScalarChannel roughness;
  private final ScalarChannel specular;
  private final ColorChannel specularColor;
  private final ScalarChannel transmission;
  private final ScalarChannel clearcoat;
  private final ScalarChannel clearcoatRoughness;
  private final Optional<NormalChannel> coatNormals;
  private final ColorChannel sheenColor;
  private final ScalarChannel sheenRoughness;
  private final ScalarChannel anisotropy;
  private final ScalarChannel anisotropyRotation;
  private final Optional<NormalChannel> anisotropyDirection;
  private final double ior;
  private final Rgb absorption;
  private final boolean isAnisotropic;
  private final boolean isThin;
  private final boolean isThinlyTransmissive;
  private final boolean isTransparent;
  private final boolean isDoubleSided;
  private final boolean isUniform;
  private final boolean isOpaque;

  private MetallicRoughness(Builder values) {
    stated = Map.copyOf(values.stated);
    baseColor = values.color(MaterialParameter.BASE_COLOR);
    opacity = values.number(MaterialParameter.OPACITY);
    metallic = values.number(MaterialParameter.METALLIC);
    roughness = values.number(MaterialParameter.ROUGHNESS);
    specular = values.number(MaterialParameter.SPECULAR);
    specularColor = values.color(MaterialParameter.SPECULAR_COLOR);
    transmission = values.number(MaterialParameter.TRANSMISSION);
    clearcoat = values.number(MaterialParameter.CLEARCOAT);
    clearcoatRoughness = values.number(MaterialParameter.CLEARCOAT_ROUGHNESS);
    coatNormals = values.normals(MaterialParameter.CLEARCOAT_NORMAL);
    sheenColor = values.color(MaterialParameter.SHEEN_COLOR);
    sheenRoughness = values.number(MaterialParameter.SHEEN_ROUGHNESS);
    anisotropy = values.number(MaterialParameter.ANISOTROPY);
    anisotropyRotation = values.number(MaterialParameter.ANISOTROPY_ROTATION);
    anisotropyDirection = values.normals(MaterialParameter.ANISOTROPY_DIRECTION);
    isAnisotropic = stated.containsKey(MaterialParameter.ANISOTROPY);
    ior = values.number(MaterialParameter.IOR).at(ORIGIN);
    absorption =
        absorption(
            values.color(MaterialParameter.ATTENUATION_COLOR).at(ORIGIN),
            values.number(MaterialParameter.ATTENUATION_DISTANCE).at(ORIGIN));
    isThin = !stated.containsKey(MaterialParameter.ATTENUATION_DISTANCE);
    isThinlyTransmissive = isThin && stated.containsKey(MaterialParameter.TRANSMISSION);
    isTransparent = stated.containsKey(MaterialParameter.OPACITY);
    isDoubleSided = !values.isSingleSided || !isThin;
    isUniform = stated.values().stream().allMatch(Channel::isConstant);
    isOpaque = !isTransparent && isDoubleSided && !isThinlyTransmissive;
  }

  /**
   * Returns the absorption coefficient of a medium in which white light has a color after some
   * distance (Beer's law).
   *
   * @param color components in [0,1]; 0 counts as 1e-9
   * @param distance &gt; 0; infinite for a clear medium
   * @return per unit of the distance
   */
  private static Rgb absorption(Rgb color, double distance) {
    DoubleUnaryOperator of = c -> c >= 1 ? 0 : -Elementary.log(Math.max(c, 1e-9)) / distance;
    return new Rgb(
        of.applyAsDouble(color.r()), of.applyAsDouble(color.g()), of.applyAsDouble(color.b()));
  }

  /** Returns the value of a parameter; empty if it has its default. */
  public Optional<Channel> stated(MaterialParameter parameter) {
    return Optional.ofNullable(stated.get(parameter));
  }

  /** Returns whether back faces are visible. */
  public boolean isDoubleSided() {
    return isDoubleSided;
  }

  /** Returns a builder of a white, rough metal that is opaque and double-sided. */
  public static Builder builder() {
    return new Builder();
  }

  @Override
  public boolean isUniform() {
    return isUniform;
  }

  @Override
  public Material simplified() {
    return isUniform && isOpaque && absorption().isBlack() ? new UniformMaterial(at(0, 0)) : this;
  }

  @Override
  public boolean isOpaque() {
    return isOpaque;
  }

  /** {@inheritDoc} Back faces of a single-sided surface are invisible. */
  @Override
  public Rgb transmittance(SurfaceHit hit) {
    if (!isDoubleSided && !hit.isFrontal()) {
      return Rgb.WHITE;
    }
    double opacity = opacity(hit);
    Rgb straight = Rgb.grey(1 - opacity);
    return opacity == 0 ? straight : straight.plus(smoothlyTransmitted(hit).times(opacity));
  }

  private double opacity(SurfaceHit hit) {
    return isTransparent ? unit(opacity.at(hit)) : 1;
  }

  /** Returns what smooth thin transmission passes; black for other surfaces. */
  private Rgb smoothlyTransmitted(SurfaceHit hit) {
    if (!isThinlyTransmissive || alpha(roughness, hit) >= CookTorrance.SMOOTH) {
      return Rgb.BLACK;
    }
    double share = glassShare(hit);
    double cosine = Math.abs(hit.wo().dot(hit.shadingNormal()));
    Rgb reflected = SchlickReflection.fresnel(dielectricF0(hit), f90(hit), cosine);
    Rgb tint = baseColor(hit).times(share * passedByLayers(hit, cosine));
    return ThinGlass.passed(tint, reflected);
  }

  /** Returns the fraction of light that sheen and clear coat leave to straight transmission. */
  private double passedByLayers(SurfaceHit hit, double cosine) {
    double sheen = sheenColor(hit).max() * Sheen.albedo(cosine, unit(sheenRoughness.at(hit)));
    return (1 - sheen) * (1 - coatAlbedo(unit(clearcoat.at(hit)), cosine, coatAlpha(hit)));
  }

  private Rgb sheenColor(SurfaceHit hit) {
    return sheenColor.at(hit).clampedToOne();
  }

  private double coatAlpha(SurfaceHit hit) {
    return Math.max(MIN_ALPHA, alpha(clearcoatRoughness, hit));
  }

  private static double coatAlbedo(double coat, double cosine, double alpha) {
    return GgxAlbedo.of(coat * COAT_F0, coat, cosine, alpha);
  }

  /** Returns the fraction of the surface that transmits light. */
  private double glassShare(SurfaceHit hit) {
    return (1 - unit(metallic.at(hit))) * unit(transmission.at(hit));
  }

  @Override
  public Rgb absorption() {
    return absorption;
  }

  private static double unit(double x) {
    return x > 0 ? Math.min(1, x) : 0;
  }

  private static double alpha(ScalarChannel roughness, SurfaceHit hit) {
    double perceptual = unit(roughness.at(hit));
    return perceptual * perceptual;
  }

  private Rgb baseColor(SurfaceHit hit) {
    return baseColor.at(hit).clampedToOne();
  }

  private Rgb dielectricF0(SurfaceHit hit) {
    double ratio = ior == 0 ? 1 : (ior - 1) / (ior + 1);
    Rgb color = specularColor.at(hit).times(ratio * ratio);
    return color.clampedToOne().times(unit(specular.at(hit)));
  }

  private double f90(SurfaceHit hit) {
    return unit(specular.at(hit));
  }

  @Override
  public Bsdf at(double u, double v) {
    TexturePoint point = new TexturePoint(u, v);
    return at(new SurfaceHit().set(Vec3.ZERO, Vec3.Z, Frame.WORLD, point, Vec3.Z, 0));
  }

  @Override
  public Bsdf at(SurfaceHit hit) {
    return coated(belowCoat(hit), hit);
  }

  /** Returns whether a clear coat may cover the surface somewhere. */
  boolean mayBeCoated() {
    return !clearcoat.isConstant() || unit(clearcoat.at(ORIGIN)) > 0;
  }

  /** Returns whether a clear coat covers the surface at a hit. */
  boolean isCoated(SurfaceHit hit) {
    return unit(clearcoat.at(hit)) > 0;
  }

  /** Returns how the surface scatters at a hit, with a perturbed normal below the clear coat. */
  Bsdf at(SurfaceHit hit, NormalChannel belowCoat) {
    return coated(belowCoat.tilted(belowCoat(hit), hit), hit);
  }

  private Bsdf belowCoat(SurfaceHit hit) {
    Bsdf base = base(hit);
    Rgb sheenColor = sheenColor(hit);
    if (sheenColor.isBlack()) {
      return base;
    }
    double roughness = unit(sheenRoughness.at(hit));
    double most = sheenColor.max();
    return new Layered(
        new Sheen(sheenColor, roughness),
        base,
        (x, y, z) -> most * Sheen.albedo(Math.abs(z), roughness));
  }

  /** Returns a BSDF below the clear coat, times the opacity. */
  private Bsdf coated(Bsdf base, SurfaceHit hit) {
    double coat = unit(clearcoat.at(hit));
    Bsdf bsdf = coat > 0 ? coated(base, coat, coatAlpha(hit), hit) : base;
    double opacity = opacity(hit);
    return opacity < 1 ? new Faded(bsdf, opacity) : bsdf;
  }

  private Bsdf coated(Bsdf base, double coat, double alpha, SurfaceHit hit) {
    Lobe smooth = new SchlickReflection(Rgb.grey(coat * COAT_F0), coat, new Ggx(alpha));
    if (coatNormals.isPresent() && coatNormals.get().tilted(smooth, hit) instanceof Tilted bumpy) {
      return new Layered(bumpy, base, (x, y, z) -> coatAlbedo(coat, bumpy.cosine(x, y, z), alpha));
    }
    return new Layered(smooth, base, (x, y, z) -> coatAlbedo(coat, Math.abs(z), alpha));
  }

  /** Returns the BSDF without sheen and clear coat. */
  private Bsdf base(SurfaceHit hit) {
    double metal = unit(metallic.at(hit));
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
    double facetAlpha = Math.max(MIN_ALPHA, alpha);
    double strength = isAnisotropic ? unit(anisotropy.at(hit)) : 0;
    // Schlick's approximation is linear in F0 and F90: the mean of both reflections is one lobe.
    Rgb mixedF0 = f0.times(1 - metallic).plus(color.times(metallic));
    double mixedF90 = f90 * (1 - metallic) + metallic;
    Lobe reflection =
        strength > 0
            ? anisotropic(hit, mixedF0, mixedF90, facetAlpha, strength)
            : new SchlickReflection(mixedF0, mixedF90, new Ggx(facetAlpha));
    if (metallic == 1 || color.isBlack()) {
      return reflection;
    }
    Rgb albedo = color.times(1 - metallic);
    LayeredDiffuse diffuse =
        strength > 0
            ? AnisotropicReflection.below(albedo, f0.max(), f90, facetAlpha, strength)
            : new LayeredDiffuse(albedo, f0.max(), f90, facetAlpha);
    return new Mixture(diffuse, reflection);
  }

  private Lobe anisotropic(SurfaceHit hit, Rgb f0, double f90, double alpha, double strength) {
    Vec3 direction =
        anisotropyDirection
            .map(texture -> texture.map().normal(hit.u(texture.uvSet()), hit.v(texture.uvSet())))
            .orElse(Vec3.X);
    double degrees = anisotropyRotation.at(hit);
    return AnisotropicReflection.along(direction, degrees, f0, f90, alpha, strength);
  }

  private Bsdf glass(SurfaceHit hit, Rgb tint, double alpha) {
    if (isThin) {
      Rgb f0 = dielectricF0(hit);
      Ggx facets = new Ggx(Math.max(MIN_ALPHA, alpha));
      return alpha < CookTorrance.SMOOTH
          ? new SchlickReflection(f0, f90(hit), facets)
          : new ThinGlass(tint, f0, f90(hit), facets);
    }
    double index = ior == 0 ? 1e6 : Math.max(1, ior);
    return alpha < CookTorrance.SMOOTH || index - 1 < 1e-8
        ? new Dielectric(Rgb.WHITE, tint, index)
        : new RoughDielectric(Rgb.WHITE, tint, index, new Ggx(alpha));
  }

  /** Builds a {@link MetallicRoughness}. Mutable. */
  public static final class Builder {
    private final Map<MaterialParameter, Channel> stated = new HashMap<>();
    private boolean isSingleSided;

    private Builder() {}

    /**
     * Sets a parameter.
     *
     * @throws IllegalArgumentException if it has values of another kind, or must be constant
     */
    public Builder set(MaterialParameter parameter, Channel value) {
      stated.put(parameter, parameter.require(value));
      return this;
    }

    /**
     * Sets a number.
     *
     * @throws IllegalArgumentException if the parameter is no number, or the value is out of range
     */
    public Builder set(MaterialParameter parameter, double value) {
      return set(parameter, parameter.constant(Rgb.grey(value)));
    }

    /**
     * Sets a linear color.
     *
     * @throws IllegalArgumentException if the parameter is no color, or the value is out of range
     */
    public Builder set(MaterialParameter parameter, Rgb value) {
      return set(parameter, parameter.constant(value));
    }

    /** Makes back faces invisible, unless the surface is the boundary of a volume. */
    public Builder singleSided() {
      isSingleSided = true;
      return this;
    }

    private Channel value(MaterialParameter parameter) {
      Channel value = stated.get(parameter);
      return value == null ? parameter.constant(parameter.missing()) : value;
    }

    private ColorChannel color(MaterialParameter parameter) {
      return (ColorChannel) value(parameter);
    }

    private Optional<NormalChannel> normals(MaterialParameter parameter) {
      return Optional.ofNullable((NormalChannel) stated.get(parameter));
    }

    private ScalarChannel number(MaterialParameter parameter) {
      return (ScalarChannel) value(parameter);
    }

    /** Returns the material. */
    public MetallicRoughness build() {
      return new MetallicRoughness(this);
    }
  }
}
