package io.github.lumbre.model.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.texture.Texture;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * A metallic-roughness material as a model states it: the parameters of glTF 2.0 and of its {@code
 * KHR_materials_} extensions. Immutable; {@link #builder} builds it.
 *
 * @param name empty if it has none
 * @param location in the file, such as {@code materials[2]}; empty for a default material
 * @param inputs the parameters that the model states
 * @param normalMap empty if there is none
 * @param emission the emitted radiance; the factor includes the emissive strength
 * @param alphaMode the meaning of {@link MaterialParameter#OPACITY}
 * @param alphaCutoff the threshold of {@link AlphaMode#MASK}
 * @param doubleSided whether back faces are visible
 * @param unlit whether the base color is emitted instead of lit (KHR_materials_unlit)
 * @param flat whether an unlit surface shows its color and gives no light
 * @param glossy whether {@link MaterialParameter#ROUGHNESS} is the glossiness, 1 - roughness, and
 *     {@link MaterialParameter#BASE_COLOR} is multiplied by 1 - the largest component of {@link
 *     MaterialParameter#SPECULAR_COLOR} (KHR_materials_pbrSpecularGlossiness)
 * @param hatch lines on the surface in which a section cuts a part, instead of the base color;
 *     empty for surfaces of the file
 */
public record ModelMaterial(
    String name,
    String location,
    Map<MaterialParameter, MaterialInput> inputs,
    Optional<MaterialInput> normalMap,
    MaterialInput emission,
    AlphaMode alphaMode,
    double alphaCutoff,
    boolean doubleSided,
    boolean unlit,
    boolean flat,
    boolean glossy,
    Optional<Texture<Rgb>> hatch) {
  /** The meaning of {@link MaterialParameter#OPACITY}. */
  public enum AlphaMode {
    /** Opacity is ignored. */
    OPAQUE,
    /** A point is visible if its opacity is at least {@link #alphaCutoff}. */
    MASK,
    /** Opacity is the fraction of light that the surface stops. */
    BLEND
  }

  public ModelMaterial {
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(location, "location");
    inputs = Map.copyOf(inputs);
    Objects.requireNonNull(normalMap, "normalMap");
    Objects.requireNonNull(emission, "emission");
    Objects.requireNonNull(alphaMode, "alphaMode");
    Objects.requireNonNull(hatch, "hatch");
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

  /** Returns this material, visible from both sides. */
  public ModelMaterial fromBothSides() {
    return new ModelMaterial(
        name,
        location,
        inputs,
        normalMap,
        emission,
        alphaMode,
        alphaCutoff,
        true,
        unlit,
        flat,
        glossy,
        hatch);
  }

  /** Returns this material with a number that it states, times a factor. */
  ModelMaterial scaled(MaterialParameter parameter, double factor) {
    MaterialInput stated = input(parameter);
    Map<MaterialParameter, MaterialInput> changed = new HashMap<>(inputs);
    changed.put(parameter, stated.withFactor(stated.factor().times(factor)));
    return new ModelMaterial(
        name,
        location,
        changed,
        normalMap,
        emission,
        alphaMode,
        alphaCutoff,
        doubleSided,
        unlit,
        flat,
        glossy,
        hatch);
  }

  /** Returns the value of a parameter; its default if the model does not state it. */
  public MaterialInput input(MaterialParameter parameter) {
    return inputs.getOrDefault(parameter, MaterialInput.of(parameter.defaultValue()));
  }

  /**
   * Returns whether a parameter has an effect: the model states it, and neither it nor all
   * strengths of its layer are 0.
   */
  public boolean uses(MaterialParameter parameter) {
    return inputs.containsKey(parameter) && !parameter.strengths().stream().allMatch(this::isOff);
  }

  private boolean isOff(MaterialParameter strength) {
    return strength.defaultValue().isBlack() && input(strength).factor().isBlack();
  }

  /** Builds a {@link ModelMaterial}. Mutable. */
  public static final class Builder {
    private final String name;
    private final String location;
    private final Map<MaterialParameter, MaterialInput> inputs = new HashMap<>();
    private Optional<MaterialInput> normalMap = Optional.empty();
    private MaterialInput emission = MaterialInput.of(Rgb.BLACK);
    private AlphaMode alphaMode = AlphaMode.OPAQUE;
    private double alphaCutoff = .5;
    private boolean doubleSided;
    private Optional<Texture<Rgb>> hatch = Optional.empty();
    private boolean unlit;
    private boolean flat;
    private boolean glossy;

    private Builder(String name, String location) {
      this.name = name;
      this.location = location;
    }

    public Builder set(MaterialParameter parameter, MaterialInput value) {
      inputs.put(parameter, value);
      return this;
    }

    /** Sets a number without a texture. */
    public Builder set(MaterialParameter parameter, double value) {
      return set(parameter, MaterialInput.of(value));
    }

    /** Sets a color without a texture. */
    public Builder set(MaterialParameter parameter, Rgb value) {
      return set(parameter, MaterialInput.of(value));
    }

    /** Sets {@link ModelMaterial#normalMap}. */
    public Builder normalMap(Optional<MaterialInput> value) {
      normalMap = value;
      return this;
    }

    /** Sets {@link ModelMaterial#emission}. */
    public Builder emission(MaterialInput value) {
      emission = value;
      return this;
    }

    /** Sets {@link ModelMaterial#alphaMode}. */
    public Builder alphaMode(AlphaMode value) {
      alphaMode = value;
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

    /** Sets {@link ModelMaterial#hatch}. */
    public Builder hatch(Texture<Rgb> value) {
      hatch = Optional.of(value);
      return this;
    }

    /** Sets {@link ModelMaterial#unlit}. */
    public Builder unlit(boolean value) {
      unlit = value;
      return this;
    }

    /** Makes the surface unlit and {@linkplain ModelMaterial#flat flat}. */
    Builder flat() {
      unlit = true;
      flat = true;
      return this;
    }

    /** Sets {@link ModelMaterial#glossy}. */
    public Builder glossy(boolean value) {
      glossy = value;
      return this;
    }

    public ModelMaterial build() {
      return new ModelMaterial(
          name,
          location,
          inputs,
          normalMap,
          emission,
          alphaMode,
          alphaCutoff,
          doubleSided,
          unlit,
          flat,
          glossy,
          hatch);
    }
  }
}
