package io.github.lumbre.material;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.texture.NormalMap;
import io.github.lumbre.texture.TexturePoint;
import java.util.Objects;
import java.util.Optional;

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

  private final Builder values;
  private final boolean isUniform;
  private final boolean isOpaque;

  private MetallicRoughness(Builder builder) {
    values = new Builder(builder);
    isUniform =
        values.baseColor.isConstant()
            && values.metallic.isConstant()
            && values.roughness.isConstant()
            && values.specular.isConstant()
            && values.specularColor.isConstant()
            && values.transmission.isConstant()
            && values.clearcoat.isConstant()
            && values.clearcoatRoughness.isConstant()
            && values.sheenColor.isConstant()
            && values.sheenRoughness.isConstant()
            && values.opacity.isConstant()
            && values.coatNormals.isEmpty();
    isOpaque = !values.isTransparent && values.isDoubleSided && !values.isThinlyTransmissive();
  }

  /**
   * Returns the absorption coefficient of a medium in which white light has a color after some
   * distance (Beer's law).
   *
   * @param color components in [0,1]; 0 counts as 1e-9
   * @param distance &gt; 0; infinite for a clear medium
   * @return per unit of the distance
   */
  public static Rgb absorption(Rgb color, double distance) {
    return new Rgb(
        absorption(color.r(), distance),
        absorption(color.g(), distance),
        absorption(color.b(), distance));
  }

  private static double absorption(double color, double distance) {
    return color >= 1 ? 0 : -Elementary.log(Math.max(color, 1e-9)) / distance;
  }

  /** Receives the properties of a material; see {@link #describe}. */
  public interface Description {
    /** Receives a color by its name in the scene format. */
    void color(String name, ColorChannel value);

    /** Receives a number by its name in the scene format. */
    void scalar(String name, ScalarChannel value);

    /** Receives a constant by its name in the scene format. */
    void number(String name, double value);

    /** Is called if back faces are invisible. */
    void singleSided();

    /** Is called if a map perturbs the normals of the clear coat. */
    void clearcoatNormals();

    /**
     * Receives the medium inside.
     *
     * @param color of white light after the distance; empty if only the absorption is known
     */
    void volume(Optional<Attenuation> color);
  }

  /**
   * The color of white light after some distance in a medium.
   *
   * @param distance in world units, &gt; 0
   */
  public record Attenuation(Rgb color, double distance) {}

  /** Passes all properties of this material on. */
  public void describe(Description to) {
    to.color("baseColor", values.baseColor);
    to.scalar("metallic", values.metallic);
    to.scalar("roughness", values.roughness);
    to.scalar("specular", values.specular);
    to.color("specularColor", values.specularColor);
    to.scalar("clearcoat", values.clearcoat);
    to.scalar("clearcoatRoughness", values.clearcoatRoughness);
    to.color("sheenColor", values.sheenColor);
    to.scalar("sheenRoughness", values.sheenRoughness);
    to.number("ior", values.ior);
    if (values.isTransparent) {
      to.scalar("opacity", values.opacity);
    }
    if (values.isTransmissive) {
      to.scalar("transmission", values.transmission);
    }
    if (!values.isDoubleSided) {
      to.singleSided();
    }
    if (values.coatNormals.isPresent()) {
      to.clearcoatNormals();
    }
    if (!values.isThin) {
      to.volume(values.attenuation);
    }
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
    if (!values.isDoubleSided && !hit.isFrontal()) {
      return Rgb.WHITE;
    }
    double opacity = opacity(hit);
    Rgb straight = Rgb.grey(1 - opacity);
    return opacity == 0 ? straight : straight.plus(smoothlyTransmitted(hit).times(opacity));
  }

  private double opacity(SurfaceHit hit) {
    return values.isTransparent ? Math.max(0, Math.min(1, values.opacity.at(hit))) : 1;
  }

  /** Returns what smooth thin transmission passes; black for other surfaces. */
  private Rgb smoothlyTransmitted(SurfaceHit hit) {
    if (!values.isThinlyTransmissive() || alpha(hit) >= CookTorrance.SMOOTH) {
      return Rgb.BLACK;
    }
    double share = glassShare(hit);
    double cosine = Math.abs(hit.wo().dot(hit.shadingNormal()));
    Rgb reflected = SchlickReflection.fresnel(dielectricF0(hit), f90(hit), cosine);
    Rgb tint = baseColor(hit).times(share * passedByLayers(hit, cosine));
    return new Rgb(
        tint.r() * (1 - reflected.r()),
        tint.g() * (1 - reflected.g()),
        tint.b() * (1 - reflected.b()));
  }

  /** Returns the fraction of light that sheen and clear coat leave to straight transmission. */
  private double passedByLayers(SurfaceHit hit, double cosine) {
    double sheen =
        sheenColor(hit).max() * Sheen.albedo(cosine, unit(values.sheenRoughness.at(hit)));
    return (1 - sheen) * (1 - coatAlbedo(unit(values.clearcoat.at(hit)), cosine, coatAlpha(hit)));
  }

  private Rgb sheenColor(SurfaceHit hit) {
    return values.sheenColor.at(hit).clampedToOne();
  }

  private double coatAlpha(SurfaceHit hit) {
    double roughness = unit(values.clearcoatRoughness.at(hit));
    return Math.max(MIN_ALPHA, roughness * roughness);
  }

  private static double coatAlbedo(double coat, double cosine, double alpha) {
    return GgxAlbedo.of(coat * COAT_F0, coat, cosine, alpha);
  }

  /** Returns the fraction of the surface that transmits light. */
  private double glassShare(SurfaceHit hit) {
    return (1 - unit(values.metallic.at(hit))) * unit(values.transmission.at(hit));
  }

  @Override
  public Rgb absorption() {
    return values.absorption;
  }

  private static double unit(double x) {
    return x > 0 ? Math.min(1, x) : 0;
  }

  private double alpha(SurfaceHit hit) {
    double roughness = unit(values.roughness.at(hit));
    return roughness * roughness;
  }

  private Rgb baseColor(SurfaceHit hit) {
    return values.baseColor.at(hit).clampedToOne();
  }

  private Rgb dielectricF0(SurfaceHit hit) {
    double ratio = values.ior == 0 ? 1 : (values.ior - 1) / (values.ior + 1);
    Rgb color = values.specularColor.at(hit).times(ratio * ratio);
    return color.clampedToOne().times(unit(values.specular.at(hit)));
  }

  private double f90(SurfaceHit hit) {
    return unit(values.specular.at(hit));
  }

  @Override
  public Bsdf at(double u, double v) {
    Frame frame = Frame.WORLD;
    return at(new SurfaceHit().set(Vec3.ZERO, Vec3.Z, frame, new TexturePoint(u, v), Vec3.Z, 0));
  }

  @Override
  public Bsdf at(SurfaceHit hit) {
    return coated(belowCoat(hit), hit);
  }

  /** Returns whether a clear coat may cover the surface somewhere. */
  boolean mayBeCoated() {
    return !values.clearcoat.isConstant() || unit(values.clearcoat.at(ORIGIN)) > 0;
  }

  /** Returns whether a clear coat covers the surface at a hit. */
  boolean isCoated(SurfaceHit hit) {
    return unit(values.clearcoat.at(hit)) > 0;
  }

  /** Returns how the surface scatters at a hit, with a perturbed normal below the clear coat. */
  Bsdf at(SurfaceHit hit, PerturbedNormal belowCoat) {
    return coated(belowCoat.tilted(belowCoat(hit), hit), hit);
  }

  private Bsdf belowCoat(SurfaceHit hit) {
    Bsdf bsdf = base(hit);
    Rgb sheenColor = sheenColor(hit);
    if (!sheenColor.isBlack()) {
      double roughness = unit(values.sheenRoughness.at(hit));
      double most = sheenColor.max();
      bsdf =
          new Layered(
              new Sheen(sheenColor, roughness),
              bsdf,
              (x, y, z) -> most * Sheen.albedo(Math.abs(z), roughness));
    }
    return bsdf;
  }

  /** Returns a BSDF below the clear coat, times the opacity. */
  private Bsdf coated(Bsdf base, SurfaceHit hit) {
    double coat = unit(values.clearcoat.at(hit));
    Bsdf bsdf = coat > 0 ? coated(base, coat, coatAlpha(hit), hit) : base;
    double opacity = opacity(hit);
    return opacity < 1 ? new Faded(bsdf, opacity) : bsdf;
  }

  private Bsdf coated(Bsdf base, double coat, double alpha, SurfaceHit hit) {
    Lobe smooth = new SchlickReflection(Rgb.grey(coat * COAT_F0), coat, new Ggx(alpha));
    if (values.coatNormals.isPresent()
        && values.coatNormals.get().tilted(smooth, hit) instanceof Tilted bumpy) {
      return new Layered(bumpy, base, (x, y, z) -> coatAlbedo(coat, bumpy.cosine(x, y, z), alpha));
    }
    return new Layered(smooth, base, (x, y, z) -> coatAlbedo(coat, Math.abs(z), alpha));
  }

  /** Returns the BSDF without sheen and clear coat. */
  private Bsdf base(SurfaceHit hit) {
    double metallic = unit(values.metallic.at(hit));
    double transmission = unit(values.transmission.at(hit));
    double glass = (1 - metallic) * transmission;
    Rgb color = baseColor(hit);
    double alpha = alpha(hit);
    if (glass == 1) {
      return glass(hit, color, alpha);
    }
    // Rounding must not make more than all of the rest a metal.
    Bsdf solid = solid(hit, color, Math.min(1, metallic / (1 - glass)), alpha);
    return glass == 0 ? solid : new Blend(glass(hit, color, alpha), solid, glass);
  }

  /** Returns a mixture of metal and plastic. */
  private Bsdf solid(SurfaceHit hit, Rgb color, double metallic, double alpha) {
    Rgb f0 = dielectricF0(hit);
    double f90 = f90(hit);
    Ggx facets = new Ggx(Math.max(MIN_ALPHA, alpha));
    // Schlick's approximation is linear in F0 and F90: the mean of both reflections is one lobe.
    Rgb mixedF0 = f0.times(1 - metallic).plus(color.times(metallic));
    double mixedF90 = f90 * (1 - metallic) + metallic;
    Lobe reflection = new SchlickReflection(mixedF0, mixedF90, facets);
    if (metallic == 1 || color.isBlack()) {
      return reflection;
    }
    Rgb albedo = color.times(1 - metallic);
    return new Mixture(new LayeredDiffuse(albedo, f0.max(), f90, facets.alpha()), reflection);
  }

  private Bsdf glass(SurfaceHit hit, Rgb tint, double alpha) {
    if (values.isThin) {
      Rgb f0 = dielectricF0(hit);
      Ggx facets = new Ggx(Math.max(MIN_ALPHA, alpha));
      return alpha < CookTorrance.SMOOTH
          ? new SchlickReflection(f0, f90(hit), facets)
          : new ThinGlass(tint, f0, f90(hit), facets);
    }
    double ior = values.ior == 0 ? 1e6 : Math.max(1, values.ior);
    return alpha < CookTorrance.SMOOTH || ior - 1 < 1e-8
        ? new Dielectric(Rgb.WHITE, tint, ior)
        : new RoughDielectric(Rgb.WHITE, tint, ior, new Ggx(alpha));
  }

  /** Builds a {@link MetallicRoughness}. Mutable. */
  public static final class Builder {
    private ColorChannel baseColor = ColorChannel.of(Rgb.WHITE);
    private ScalarChannel opacity = ScalarChannel.of(1);
    private ScalarChannel metallic = ScalarChannel.of(1);
    private ScalarChannel roughness = ScalarChannel.of(1);
    private ScalarChannel specular = ScalarChannel.of(1);
    private ColorChannel specularColor = ColorChannel.of(Rgb.WHITE);
    private ScalarChannel transmission = ScalarChannel.of(0);
    private ScalarChannel clearcoat = ScalarChannel.of(0);
    private ScalarChannel clearcoatRoughness = ScalarChannel.of(0);
    private Optional<PerturbedNormal> coatNormals = Optional.empty();
    private ColorChannel sheenColor = ColorChannel.of(Rgb.BLACK);
    private ScalarChannel sheenRoughness = ScalarChannel.of(0);
    private double ior = 1.5;
    private boolean isTransparent;
    private boolean isDoubleSided = true;
    private boolean isThin = true;
    private boolean isTransmissive;
    private Rgb absorption = Rgb.BLACK;
    private Optional<Attenuation> attenuation = Optional.empty();

    private Builder() {}

    private Builder(Builder other) {
      baseColor = other.baseColor;
      opacity = other.opacity;
      metallic = other.metallic;
      roughness = other.roughness;
      specular = other.specular;
      specularColor = other.specularColor;
      transmission = other.transmission;
      clearcoat = other.clearcoat;
      clearcoatRoughness = other.clearcoatRoughness;
      coatNormals = other.coatNormals;
      sheenColor = other.sheenColor;
      sheenRoughness = other.sheenRoughness;
      ior = other.ior;
      isTransparent = other.isTransparent;
      isDoubleSided = other.isDoubleSided;
      isThin = other.isThin;
      isTransmissive = other.isTransmissive;
      absorption = other.absorption;
      attenuation = other.attenuation;
    }

    private boolean isThinlyTransmissive() {
      return isTransmissive && isThin;
    }

    /** Sets the albedo of dielectrics and the reflectance of metals; the default is white. */
    public Builder baseColor(ColorChannel value) {
      baseColor = Objects.requireNonNull(value, "baseColor");
      return this;
    }

    /** Sets the fraction of light that the surface stops, in [0,1]; the default is 1. */
    public Builder opacity(ScalarChannel value) {
      opacity = Objects.requireNonNull(value, "opacity");
      isTransparent = true;
      return this;
    }

    /** Sets the metalness: 0 for dielectrics to 1 for metals, the default. */
    public Builder metallic(ScalarChannel value) {
      metallic = Objects.requireNonNull(value, "metallic");
      return this;
    }

    /** Sets the perceptual roughness, in [0,1]: the square root of α; the default is 1. */
    public Builder roughness(ScalarChannel value) {
      roughness = Objects.requireNonNull(value, "roughness");
      return this;
    }

    /** Sets the strength of the dielectric reflection, in [0,1]; the default is 1. */
    public Builder specular(ScalarChannel value) {
      specular = Objects.requireNonNull(value, "specular");
      return this;
    }

    /** Sets the tint of the dielectric reflection at normal incidence; the default is white. */
    public Builder specularColor(ColorChannel value) {
      specularColor = Objects.requireNonNull(value, "specularColor");
      return this;
    }

    /** Sets the fraction of non-reflected light that is transmitted, in [0,1]. */
    public Builder transmission(ScalarChannel value) {
      transmission = Objects.requireNonNull(value, "transmission");
      isTransmissive = true;
      return this;
    }

    /** Sets the strength of the clear coat, in [0,1]; the default is 0. */
    public Builder clearcoat(ScalarChannel value) {
      clearcoat = Objects.requireNonNull(value, "clearcoat");
      return this;
    }

    /** Sets the perceptual roughness of the clear coat, in [0,1]. */
    public Builder clearcoatRoughness(ScalarChannel value) {
      clearcoatRoughness = Objects.requireNonNull(value, "clearcoatRoughness");
      return this;
    }

    /** Sets the normals of the clear coat; without a map, they are those of the vertices. */
    public Builder clearcoatNormals(NormalMap map, int uvSet) {
      coatNormals = Optional.of(new PerturbedNormal(map, uvSet));
      return this;
    }

    /** Sets the color of the sheen; black, the default, means none. */
    public Builder sheenColor(ColorChannel value) {
      sheenColor = Objects.requireNonNull(value, "sheenColor");
      return this;
    }

    /** Sets the perceptual roughness of the sheen, in [0,1]. */
    public Builder sheenRoughness(ScalarChannel value) {
      sheenRoughness = Objects.requireNonNull(value, "sheenRoughness");
      return this;
    }

    /**
     * Sets the index of refraction; the default is 1.5.
     *
     * @param value at least 1, or 0 for a dielectric that reflects everything
     */
    public Builder ior(double value) {
      if (!(value == 0 || value >= 1 && value <= 1e6)) {
        throw new IllegalArgumentException("ior: expected 0 or 1 to 1e6, found " + value);
      }
      ior = value;
      return this;
    }

    /** Makes back faces invisible. */
    public Builder singleSided() {
      isDoubleSided = false;
      return this;
    }

    /**
     * Makes the surface the boundary of a volume, which refracts: the mesh must be closed.
     *
     * @param newAbsorption absorption coefficient inside, per world unit, each component at least 0
     */
    public Builder volume(Rgb newAbsorption) {
      absorption = Objects.requireNonNull(newAbsorption, "absorption");
      attenuation = Optional.empty();
      isThin = false;
      isDoubleSided = true;
      return this;
    }

    /**
     * Makes the surface the boundary of a volume, which refracts: the shape must be closed.
     *
     * @param color of white light after the distance, each component in [0, 1]
     * @param distance in world units, &gt; 0
     * @throws IllegalArgumentException if a number is out of range
     */
    public Builder volume(Rgb color, double distance) {
      Values.reflectance("color", color);
      if (!(distance > 0)) {
        throw new IllegalArgumentException("distance: expected > 0, found " + distance);
      }
      volume(MetallicRoughness.absorption(color, distance));
      attenuation = Optional.of(new Attenuation(color, distance));
      return this;
    }

    /** Sets the albedo of dielectrics and the reflectance of metals, each component in [0, 1]. */
    public Builder baseColor(Rgb value) {
      return baseColor(ColorChannel.of(Values.reflectance("baseColor", value), 0));
    }

    /** Sets the metalness: 0 for dielectrics to 1 for metals. */
    public Builder metallic(double value) {
      return metallic(ScalarChannel.of(Values.number("metallic", value, 0, 1), 0));
    }

    /** Sets the perceptual roughness, in [0, 1]. */
    public Builder roughness(double value) {
      return roughness(ScalarChannel.of(Values.number("roughness", value, 0, 1), 0));
    }

    /** Sets the fraction of light that the surface stops, in [0, 1]. */
    public Builder opacity(double value) {
      return opacity(ScalarChannel.of(Values.number("opacity", value, 0, 1), 0));
    }

    /** Sets the fraction of non-reflected light that is transmitted, in [0, 1]. */
    public Builder transmission(double value) {
      return transmission(ScalarChannel.of(Values.number("transmission", value, 0, 1), 0));
    }

    /** Sets the strength of the clear coat, in [0, 1]. */
    public Builder clearcoat(double value) {
      return clearcoat(ScalarChannel.of(Values.number("clearcoat", value, 0, 1), 0));
    }

    /** Returns the material. */
    public MetallicRoughness build() {
      return new MetallicRoughness(this);
    }
  }
}
