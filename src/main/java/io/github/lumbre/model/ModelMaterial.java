package io.github.lumbre.model;

import io.github.lumbre.image.Rgb;
import java.util.Objects;
import java.util.Optional;

/**
 * A metallic-roughness material: the parameters of glTF 2.0 and of its {@code KHR_materials_}
 * extensions. Immutable; {@link #builder} builds it.
 */
public final class ModelMaterial {
  /** The meaning of {@link #opacity}. */
  public enum AlphaMode {
    /** Opacity is ignored. */
    OPAQUE,
    /** A point is visible if its opacity is at least {@link #alphaCutoff}. */
    MASK,
    /** Opacity is the fraction of light that the surface stops. */
    BLEND
  }

  /**
   * The inside of a closed mesh (KHR_materials_volume).
   *
   * @param attenuationDistance the distance, in world units, at which white light has the
   *     attenuation color; &gt; 0, infinite for a clear medium
   * @param attenuationColor linear, each component in [0,1]
   */
  public record Volume(double attenuationDistance, Rgb attenuationColor) {
    public Volume {
      Objects.requireNonNull(attenuationColor, "attenuationColor");
    }
  }

  private final Builder values;

  private ModelMaterial(Builder builder) {
    values = new Builder(builder);
  }

  /**
   * Returns a builder of a material with the defaults of glTF 2.0: white, metallic 1, roughness 1.
   *
   * @param name empty if it has none
   * @param location in the file, such as {@code materials[2]}; empty for a default material
   */
  public static Builder builder(String name, String location) {
    return new Builder(name, location);
  }

  /** Returns the name; empty if it has none. */
  public String name() {
    return values.name;
  }

  /** Returns the place in the file; empty for a default material. */
  public String location() {
    return values.location;
  }

  /** Returns the albedo of dielectrics and the normal-incidence reflectance of metals. */
  public ColorInput baseColor() {
    return values.baseColor;
  }

  /** Returns the opacity, in [0,1]; see {@link #alphaMode}. */
  public ScalarInput opacity() {
    return values.opacity;
  }

  /** Returns the metalness: 0 for dielectrics to 1 for metals. */
  public ScalarInput metallic() {
    return values.metallic;
  }

  /** Returns the perceptual roughness in [0,1]: the square root of the microfacet alpha. */
  public ScalarInput roughness() {
    return values.roughness;
  }

  /** Returns the normal map; empty if there is none. */
  public Optional<NormalInput> normalMap() {
    return values.normalMap;
  }

  /** Returns the emitted radiance; the factor includes the emissive strength. */
  public ColorInput emission() {
    return values.emission;
  }

  /** Returns the meaning of the opacity. */
  public AlphaMode alphaMode() {
    return values.alphaMode;
  }

  /** Returns the threshold of {@link AlphaMode#MASK}. */
  public double alphaCutoff() {
    return values.alphaCutoff;
  }

  /** Returns whether back faces are visible. */
  public boolean doubleSided() {
    return values.doubleSided;
  }

  /** Returns whether the base color is emitted instead of lit (KHR_materials_unlit). */
  public boolean unlit() {
    return values.unlit;
  }

  /**
   * Returns the index of refraction: at least 1, or 0 for a Fresnel reflectance of 1
   * (KHR_materials_ior).
   */
  public double ior() {
    return values.ior;
  }

  /** Returns the strength of the dielectric reflection (KHR_materials_specular). */
  public ScalarInput specular() {
    return values.specular;
  }

  /** Returns the tint of the dielectric reflection at normal incidence (KHR_materials_specular). */
  public ColorInput specularColor() {
    return values.specularColor;
  }

  /**
   * Returns the fraction of non-reflected light that is transmitted (KHR_materials_transmission).
   */
  public ScalarInput transmission() {
    return values.transmission;
  }

  /** Returns the medium inside; empty if the surface is thin-walled (KHR_materials_volume). */
  public Optional<Volume> volume() {
    return values.volume;
  }

  /** Returns the strength of the clear coat (KHR_materials_clearcoat). */
  public ScalarInput clearcoat() {
    return values.clearcoat;
  }

  /** Returns the perceptual roughness of the clear coat. */
  public ScalarInput clearcoatRoughness() {
    return values.clearcoatRoughness;
  }

  /** Returns the normal map of the clear coat; empty if there is none. */
  public Optional<NormalInput> clearcoatNormalMap() {
    return values.clearcoatNormalMap;
  }

  /** Returns the albedo of the sheen; black for none (KHR_materials_sheen). */
  public ColorInput sheenColor() {
    return values.sheenColor;
  }

  /** Returns the perceptual roughness of the sheen. */
  public ScalarInput sheenRoughness() {
    return values.sheenRoughness;
  }

  /** Builds a {@link ModelMaterial}. Mutable. */
  public static final class Builder {
    private final String name;
    private final String location;
    private ColorInput baseColor = ColorInput.of(Rgb.WHITE);
    private ScalarInput opacity = ScalarInput.of(1);
    private ScalarInput metallic = ScalarInput.of(1);
    private ScalarInput roughness = ScalarInput.of(1);
    private Optional<NormalInput> normalMap = Optional.empty();
    private ColorInput emission = ColorInput.of(Rgb.BLACK);
    private AlphaMode alphaMode = AlphaMode.OPAQUE;
    private double alphaCutoff = .5;
    private boolean doubleSided = false;
    private boolean unlit = false;
    private double ior = 1.5;
    private ScalarInput specular = ScalarInput.of(1);
    private ColorInput specularColor = ColorInput.of(Rgb.WHITE);
    private ScalarInput transmission = ScalarInput.of(0);
    private Optional<Volume> volume = Optional.empty();
    private ScalarInput clearcoat = ScalarInput.of(0);
    private ScalarInput clearcoatRoughness = ScalarInput.of(0);
    private Optional<NormalInput> clearcoatNormalMap = Optional.empty();
    private ColorInput sheenColor = ColorInput.of(Rgb.BLACK);
    private ScalarInput sheenRoughness = ScalarInput.of(0);

    private Builder(String name, String location) {
      this.name = Objects.requireNonNull(name, "name");
      this.location = Objects.requireNonNull(location, "location");
    }

    private Builder(Builder other) {
      name = other.name;
      location = other.location;
      baseColor = other.baseColor;
      opacity = other.opacity;
      metallic = other.metallic;
      roughness = other.roughness;
      normalMap = other.normalMap;
      emission = other.emission;
      alphaMode = other.alphaMode;
      alphaCutoff = other.alphaCutoff;
      doubleSided = other.doubleSided;
      unlit = other.unlit;
      ior = other.ior;
      specular = other.specular;
      specularColor = other.specularColor;
      transmission = other.transmission;
      volume = other.volume;
      clearcoat = other.clearcoat;
      clearcoatRoughness = other.clearcoatRoughness;
      clearcoatNormalMap = other.clearcoatNormalMap;
      sheenColor = other.sheenColor;
      sheenRoughness = other.sheenRoughness;
    }

    /** Sets {@link ModelMaterial#baseColor}. */
    public Builder baseColor(ColorInput value) {
      baseColor = Objects.requireNonNull(value, "baseColor");
      return this;
    }

    /** Sets {@link ModelMaterial#opacity}. */
    public Builder opacity(ScalarInput value) {
      opacity = Objects.requireNonNull(value, "opacity");
      return this;
    }

    /** Sets {@link ModelMaterial#metallic}. */
    public Builder metallic(ScalarInput value) {
      metallic = Objects.requireNonNull(value, "metallic");
      return this;
    }

    /** Sets {@link ModelMaterial#roughness}. */
    public Builder roughness(ScalarInput value) {
      roughness = Objects.requireNonNull(value, "roughness");
      return this;
    }

    /** Sets {@link ModelMaterial#normalMap}. */
    public Builder normalMap(Optional<NormalInput> value) {
      normalMap = Objects.requireNonNull(value, "normalMap");
      return this;
    }

    /** Sets {@link ModelMaterial#emission}. */
    public Builder emission(ColorInput value) {
      emission = Objects.requireNonNull(value, "emission");
      return this;
    }

    /** Sets {@link ModelMaterial#alphaMode}. */
    public Builder alphaMode(AlphaMode value) {
      alphaMode = Objects.requireNonNull(value, "alphaMode");
      return this;
    }

    /** Sets {@link ModelMaterial#alphaCutoff}. */
    public Builder alphaCutoff(double value) {
      alphaCutoff = value;
      return this;
    }

    /** Sets {@link ModelMaterial#doubleSided}. */
    public Builder doubleSided(boolean value) {
      doubleSided = value;
      return this;
    }

    /** Sets {@link ModelMaterial#unlit}. */
    public Builder unlit(boolean value) {
      unlit = value;
      return this;
    }

    /** Sets {@link ModelMaterial#ior}. */
    public Builder ior(double value) {
      ior = value;
      return this;
    }

    /** Sets {@link ModelMaterial#specular}. */
    public Builder specular(ScalarInput value) {
      specular = Objects.requireNonNull(value, "specular");
      return this;
    }

    /** Sets {@link ModelMaterial#specularColor}. */
    public Builder specularColor(ColorInput value) {
      specularColor = Objects.requireNonNull(value, "specularColor");
      return this;
    }

    /** Sets {@link ModelMaterial#transmission}. */
    public Builder transmission(ScalarInput value) {
      transmission = Objects.requireNonNull(value, "transmission");
      return this;
    }

    /** Sets {@link ModelMaterial#volume}. */
    public Builder volume(Optional<Volume> value) {
      volume = Objects.requireNonNull(value, "volume");
      return this;
    }

    /** Sets {@link ModelMaterial#clearcoat}. */
    public Builder clearcoat(ScalarInput value) {
      clearcoat = Objects.requireNonNull(value, "clearcoat");
      return this;
    }

    /** Sets {@link ModelMaterial#clearcoatRoughness}. */
    public Builder clearcoatRoughness(ScalarInput value) {
      clearcoatRoughness = Objects.requireNonNull(value, "clearcoatRoughness");
      return this;
    }

    /** Sets {@link ModelMaterial#clearcoatNormalMap}. */
    public Builder clearcoatNormalMap(Optional<NormalInput> value) {
      clearcoatNormalMap = Objects.requireNonNull(value, "clearcoatNormalMap");
      return this;
    }

    /** Sets {@link ModelMaterial#sheenColor}. */
    public Builder sheenColor(ColorInput value) {
      sheenColor = Objects.requireNonNull(value, "sheenColor");
      return this;
    }

    /** Sets {@link ModelMaterial#sheenRoughness}. */
    public Builder sheenRoughness(ScalarInput value) {
      sheenRoughness = Objects.requireNonNull(value, "sheenRoughness");
      return this;
    }

    /** Returns the material. */
    public ModelMaterial build() {
      return new ModelMaterial(this);
    }
  }
}
