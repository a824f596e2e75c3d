package io.github.lumbre.material;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.ColorChannel;
import io.github.lumbre.material.internal.NormalChannel;
import io.github.lumbre.material.internal.ScalarChannel;
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
 * KHR_materials_} extensions: specular, ior, transmission, diffuse transmission, volume,
 * anisotropy, clearcoat and sheen.
 *
 * <p>The lobes are those of the specification, with the light that rough metal and glass scatter
 * repeatedly. Unlike there, a layer's albedo weights what lies below it, so that the material never
 * reflects more light than arrives, and is reciprocal except where a layer covers glass.
 * Smooth thin transmission and partial opacity let rays pass straight through; see {@link
 * #transmittance}.
 *
 * <p>Immutable; {@link #builder} builds it.
 */
public final class MetallicRoughness implements Material {
  private static final TexturePoint ORIGIN = new TexturePoint(0, 0);

  private final Map<MaterialParameter, Channel> stated;
  private final MetallicBase base;
  private final Coverings coverings;
  private final ScalarChannel opacity;
  private final Rgb absorption;
  private final boolean isTransparent;
  private final boolean isDoubleSided;
  private final boolean isUniform;
  private final boolean isOpaque;

  private MetallicRoughness(Builder values) {
    stated = Map.copyOf(values.stated);
    boolean isThin = !values.states(MaterialParameter.ATTENUATION_DISTANCE);
    base = new MetallicBase(values, isThin);
    coverings = new Coverings(values);
    opacity = values.number(MaterialParameter.OPACITY);
    absorption =
        absorption(
            values.color(MaterialParameter.ATTENUATION_COLOR).at(ORIGIN),
            values.constant(MaterialParameter.ATTENUATION_DISTANCE));
    isTransparent = values.states(MaterialParameter.OPACITY);
    isDoubleSided = !values.isSingleSided || !isThin;
    isUniform = stated.values().stream().allMatch(Channel::isConstant);
    isOpaque = !isTransparent && isDoubleSided && !base.isThinlyTransmissive();
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
    boolean isPlain = isOpaque && absorption().isBlack() && !isDispersive();
    return isUniform && isPlain ? new UniformMaterial(at(0, 0)) : this;
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
    Rgb straight = Rgb.gray(1 - opacity);
    return opacity == 0
        ? straight
        : straight.plus(base.smoothlyTransmitted(hit, coverings).times(opacity));
  }

  @Override
  public boolean passesThroughGlass(SurfaceHit hit) {
    boolean isVisible = (isDoubleSided || hit.isFrontal()) && opacity(hit) > 0;
    return isVisible && !base.smoothlyTransmitted(hit, coverings).isBlack();
  }

  private double opacity(SurfaceHit hit) {
    return isTransparent ? opacity.fractionAt(hit) : 1;
  }

  @Override
  public boolean isDispersive() {
    return base.isDispersive();
  }

  @Override
  public Rgb absorption() {
    return absorption;
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
    return coverings.mayBeCoated();
  }

  /** Returns whether a clear coat covers the surface at a hit. */
  boolean isCoated(SurfaceHit hit) {
    return coverings.isCoated(hit);
  }

  /** Returns how the surface scatters at a hit, with a perturbed normal below the clear coat. */
  Bsdf at(SurfaceHit hit, NormalChannel belowCoat) {
    return coated(belowCoat.tilted(belowCoat(hit), hit), hit);
  }

  private Bsdf belowCoat(SurfaceHit hit) {
    return coverings.sheened(base.at(hit), hit);
  }

  /** Returns a BSDF below the clear coat, times the opacity. */
  private Bsdf coated(Bsdf base, SurfaceHit hit) {
    Bsdf bsdf = coverings.coated(base, hit);
    double opacity = opacity(hit);
    return opacity < 1 ? new Faded(bsdf, opacity) : bsdf;
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
      return set(parameter, parameter.constant(Rgb.gray(value)));
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
      return value == null ? parameter.constant(parameter.defaultValue()) : value;
    }

    ColorChannel color(MaterialParameter parameter) {
      return (ColorChannel) value(parameter);
    }

    Optional<NormalChannel> normals(MaterialParameter parameter) {
      return stated.get(parameter) instanceof NormalChannel normals
          ? Optional.of(normals)
          : Optional.empty();
    }

    ScalarChannel number(MaterialParameter parameter) {
      return (ScalarChannel) value(parameter);
    }

    /** Returns the number of a parameter that cannot vary. */
    double constant(MaterialParameter parameter) {
      return number(parameter).at(ORIGIN);
    }

    /** Returns whether a parameter has a value of its own, not its default. */
    boolean states(MaterialParameter parameter) {
      return stated.containsKey(parameter);
    }

    /** Returns the material. */
    public MetallicRoughness build() {
      return new MetallicRoughness(this);
    }
  }
}
