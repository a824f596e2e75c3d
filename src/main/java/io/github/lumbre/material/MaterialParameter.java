package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.ColorChannel;
import io.github.lumbre.material.internal.NormalChannel;
import io.github.lumbre.material.internal.ScalarChannel;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * A parameter of {@link MetallicRoughness}, with its names, values and default. This class is the
 * only declaration. The readers of scene files, glTF and material libraries (MTL), and the writer
 * of scene files use it. A new parameter needs a new constant, and the code of {@link
 * MetallicRoughness} that applies it. Immutable after its declaration.
 */
public final class MaterialParameter {
  private static final List<MaterialParameter> ALL = new ArrayList<>();

  private static final String CORE = "pbrMetallicRoughness";
  private static final String SPECULAR_EXTENSION = "KHR_materials_specular";
  private static final String COAT_EXTENSION = "KHR_materials_clearcoat";
  private static final String SHEEN_EXTENSION = "KHR_materials_sheen";

  private static final String ANISOTROPY_EXTENSION = "KHR_materials_anisotropy";
  private static final String TRANSLUCENCY_EXTENSION = "KHR_materials_diffuse_transmission";
  private static final String IRIDESCENCE_EXTENSION = "KHR_materials_iridescence";

  private static final int RED = 0;
  private static final int GREEN = 1;
  private static final int BLUE = 2;
  private static final int ALPHA = 3;

  /** The extension whose parameters are valid only if its {@code thicknessFactor} is above 0. */
  public static final String VOLUME_EXTENSION = "KHR_materials_volume";

  /** Albedo of dielectrics, and reflectance of metals at normal incidence. */
  public static final MaterialParameter BASE_COLOR =
      color("baseColor", Rgb.WHITE)
          .meaning("Albedo of dielectrics and reflectance of metals, linear; times the texture.")
          .gltf(CORE, "baseColorFactor", "baseColorTexture", 0);

  /** Fraction of light that the surface stops; in glTF, the fourth number of the base color. */
  public static final MaterialParameter OPACITY =
      number("opacity", 1)
          .meaning("Fraction of light that does not pass straight through.")
          .gltf(CORE, "baseColorFactor", "baseColorTexture", ALPHA);

  /** Metalness: 0 for dielectrics to 1 for metals. */
  public static final MaterialParameter METALLIC =
      number("metallic", 1)
          .meaning("From a dielectric to a metal.")
          .gltf(CORE, "metallicFactor", "metallicRoughnessTexture", BLUE)
          .mtl("pm");

  /** Perceptual roughness: the square root of α. */
  public static final MaterialParameter ROUGHNESS =
      number("roughness", 1)
          .meaning("Perceptual roughness: the square root of the distribution's parameter.")
          .gltf(CORE, "roughnessFactor", "metallicRoughnessTexture", GREEN)
          .mtl("pr");

  /** Index of refraction of dielectrics; 0 for one that reflects everything. */
  public static final MaterialParameter IOR =
      number("ior", 1.5)
          .meaning("Index of refraction of dielectrics.")
          .within(1, 1e6)
          .gltf("KHR_materials_ior", "ior");

  /** Strength of the reflection of dielectrics. */
  public static final MaterialParameter SPECULAR =
      number("specular", 1)
          .meaning("Strength of the reflection of dielectrics.")
          .gltf(SPECULAR_EXTENSION, "specularFactor", "specularTexture", ALPHA);

  /** Tint of the reflection of dielectrics at normal incidence. */
  public static final MaterialParameter SPECULAR_COLOR =
      color("specularColor", Rgb.WHITE)
          .meaning("Tint of the reflection of dielectrics at normal incidence, linear.")
          .within(0, Double.MAX_VALUE)
          .gltf(SPECULAR_EXTENSION, "specularColorFactor", "specularColorTexture", 0);

  /** Fraction of non-reflected light that is transmitted. */
  public static final MaterialParameter TRANSMISSION =
      number("transmission", 0)
          .meaning("Fraction of the light below the reflection that is transmitted.")
          .gltf("KHR_materials_transmission", "transmissionFactor", "transmissionTexture", RED);

  /** Fraction of non-reflected light that is transmitted diffusely instead of reflected so. */
  public static final MaterialParameter DIFFUSE_TRANSMISSION =
      number("diffuseTransmission", 0)
          .meaning(
              "Fraction of the light below the reflection that is scattered to the other side.")
          .gltf(
              TRANSLUCENCY_EXTENSION,
              "diffuseTransmissionFactor",
              "diffuseTransmissionTexture",
              ALPHA);

  /** Albedo of the diffuse transmission. */
  public static final MaterialParameter DIFFUSE_TRANSMISSION_COLOR =
      color("diffuseTransmissionColor", Rgb.WHITE)
          .meaning("Albedo of the light scattered to the other side, linear; white if missing.")
          .gltf(
              TRANSLUCENCY_EXTENSION,
              "diffuseTransmissionColorFactor",
              "diffuseTransmissionColorTexture",
              0)
          .of(DIFFUSE_TRANSMISSION);

  /** Color of white light after the attenuation distance in the volume. */
  public static final MaterialParameter ATTENUATION_COLOR =
      color("attenuationColor", Rgb.WHITE)
          .meaning("Color of white light after the attenuation distance, linear.")
          .gltf(VOLUME_EXTENSION, "attenuationColor")
          .of(TRANSMISSION, DIFFUSE_TRANSMISSION);

  /**
   * Distance, in world units, at which white light has the attenuation color; infinite in a clear
   * medium. It makes the surface the boundary of a volume, which refracts unless it transmits
   * diffusely: the shape must be closed.
   */
  public static final MaterialParameter ATTENUATION_DISTANCE =
      number("attenuationDistance", Double.POSITIVE_INFINITY)
          .meaning("In scene units; makes the surface the boundary of a volume.")
          .within(Double.MIN_VALUE, Double.POSITIVE_INFINITY)
          .gltf(VOLUME_EXTENSION, "attenuationDistance")
          .of(TRANSMISSION, DIFFUSE_TRANSMISSION);

  /**
   * Spread of the index of refraction over the colors: 20 / Abbe's number. It matters where an
   * attenuation distance makes the surface the boundary of a volume.
   */
  public static final MaterialParameter DISPERSION =
      number("dispersion", 0)
          .meaning(
              "Spread of the index of refraction of a volume over the colors: 20 / Abbe's number.")
          .within(0, Double.MAX_VALUE)
          .gltf("KHR_materials_dispersion", "dispersion")
          .of(TRANSMISSION);

  /** Strength of the clear coat. */
  public static final MaterialParameter CLEARCOAT =
      number("clearcoat", 0)
          .meaning("Strength of the clear coat.")
          .gltf(COAT_EXTENSION, "clearcoatFactor", "clearcoatTexture", RED)
          .mtl("pc");

  /** Perceptual roughness of the clear coat. */
  public static final MaterialParameter CLEARCOAT_ROUGHNESS =
      number("clearcoatRoughness", 0)
          .meaning("Perceptual roughness of the clear coat.")
          .gltf(COAT_EXTENSION, "clearcoatRoughnessFactor", "clearcoatRoughnessTexture", GREEN)
          .mtl("pcr")
          .of(CLEARCOAT);

  /** Normals of the clear coat; without a map, the normals of the vertices. */
  public static final MaterialParameter CLEARCOAT_NORMAL =
      normals("clearcoatNormal")
          .meaning("By which the slopes of the clear coat's map are multiplied.")
          .gltf(COAT_EXTENSION, "", "clearcoatNormalTexture", 0)
          .of(CLEARCOAT);

  /** Color of the sheen; black means none. */
  public static final MaterialParameter SHEEN_COLOR =
      color("sheenColor", Rgb.BLACK)
          .meaning("Color of the sheen, linear; black if missing.")
          .gltf(SHEEN_EXTENSION, "sheenColorFactor", "sheenColorTexture", 0)
          .mtl("ps");

  /** Perceptual roughness of the sheen. */
  public static final MaterialParameter SHEEN_ROUGHNESS =
      number("sheenRoughness", 0)
          .meaning("Perceptual roughness of the sheen.")
          .gltf(SHEEN_EXTENSION, "sheenRoughnessFactor", "sheenRoughnessTexture", ALPHA)
          .of(SHEEN_COLOR);

  /** Strength of the anisotropy: how much rougher the surface is along one direction. */
  public static final MaterialParameter ANISOTROPY =
      number("anisotropy", 0)
          .meaning("How much rougher the surface is along one direction.")
          .gltf(ANISOTROPY_EXTENSION, "anisotropyStrength", "anisotropyTexture", BLUE);

  /** Angle from increasing u to the rougher direction, counterclockwise, in degrees. */
  public static final MaterialParameter ANISOTROPY_ROTATION =
      number("anisotropyRotation", 0)
          .meaning("Degrees from increasing u to the rougher direction, counterclockwise.")
          .within(-Double.MAX_VALUE, Double.MAX_VALUE)
          .gltf(ANISOTROPY_EXTENSION, "anisotropyRotation")
          .gltfUnit(180 / Math.PI)
          .of(ANISOTROPY);

  /** Directions, in red and green, that the rotation turns; without a map, increasing u. */
  public static final MaterialParameter ANISOTROPY_DIRECTION =
      normals("anisotropyDirection")
          .meaning("By which the map's components are multiplied; only the direction counts.")
          .gltf(ANISOTROPY_EXTENSION, "", "anisotropyTexture", 0)
          .of(ANISOTROPY);

  /** The part of the surface that a thin film covers, in which light interferes. */
  public static final MaterialParameter IRIDESCENCE =
      number("iridescence", 0)
          .meaning("The part of the surface that a thin film covers, in which light interferes.")
          .gltf(IRIDESCENCE_EXTENSION, "iridescenceFactor", "iridescenceTexture", RED);

  /** Index of refraction of the thin film. */
  public static final MaterialParameter IRIDESCENCE_IOR =
      number("iridescenceIor", 1.3)
          .meaning("Index of refraction of the thin film.")
          .within(1, 1e6)
          .gltf(IRIDESCENCE_EXTENSION, "iridescenceIor")
          .of(IRIDESCENCE);

  /** Thickness of the thin film where its texture is black, in nanometers. */
  public static final MaterialParameter IRIDESCENCE_THICKNESS_MINIMUM =
      number("iridescenceThicknessMinimum", 100)
          .meaning("Thickness of the thin film where iridescenceThickness is 0, in nanometers.")
          .within(0, Double.MAX_VALUE)
          .gltf(IRIDESCENCE_EXTENSION, "iridescenceThicknessMinimum")
          .of(IRIDESCENCE);

  /** Thickness of the thin film without a texture, or where it is white, in nanometers. */
  public static final MaterialParameter IRIDESCENCE_THICKNESS_MAXIMUM =
      number("iridescenceThicknessMaximum", 400)
          .meaning("Thickness of the thin film where iridescenceThickness is 1, in nanometers.")
          .within(0, Double.MAX_VALUE)
          .gltf(IRIDESCENCE_EXTENSION, "iridescenceThicknessMaximum")
          .of(IRIDESCENCE);

  /** Thickness of the thin film: 0 for the minimum to 1 for the maximum. */
  public static final MaterialParameter IRIDESCENCE_THICKNESS =
      number("iridescenceThickness", 1)
          .meaning("Thickness of the thin film: 0 for the minimum to 1 for the maximum.")
          .gltf(IRIDESCENCE_EXTENSION, "", "iridescenceThicknessTexture", GREEN)
          .of(IRIDESCENCE);

  private final Kind kind;
  private final String key;
  private final Rgb defaultValue;
  private String meaning = "";
  private double least;
  private double most = 1;
  private String gltfObject = "";
  private String gltfFactor = "";
  private String gltfTexture = "";
  private int channel;
  private double gltfUnit = 1;
  private String mtl = "";
  private List<MaterialParameter> strengths = List.of(this);

  /** The type of a parameter's values. */
  public enum Kind {
    /** Linear RGB: a {@link ColorChannel}. Textures are sRGB-encoded. */
    COLOR,
    /** A {@link ScalarChannel}. Textures are linear. */
    NUMBER,
    /** A {@link NormalChannel}. */
    NORMALS
  }

  private MaterialParameter(Kind kind, String key, Rgb defaultValue) {
    this.kind = kind;
    this.key = key;
    this.defaultValue = defaultValue;
    ALL.add(this);
  }

  private static MaterialParameter color(String key, Rgb defaultValue) {
    return new MaterialParameter(Kind.COLOR, key, defaultValue);
  }

  private static MaterialParameter number(String key, double defaultValue) {
    return new MaterialParameter(Kind.NUMBER, key, Rgb.gray(defaultValue));
  }

  private static MaterialParameter normals(String key) {
    return new MaterialParameter(Kind.NORMALS, key, Rgb.WHITE);
  }

  private MaterialParameter meaning(String newMeaning) {
    meaning = newMeaning;
    return this;
  }

  private MaterialParameter within(double from, double to) {
    least = from;
    most = to;
    return this;
  }

  private MaterialParameter gltf(String object, String factor) {
    return gltf(object, factor, "", 0);
  }

  private MaterialParameter gltf(String object, String factor, String texture, int newChannel) {
    gltfObject = object;
    gltfFactor = factor;
    gltfTexture = texture;
    channel = newChannel;
    return this;
  }

  private MaterialParameter gltfUnit(double newUnit) {
    gltfUnit = newUnit;
    return this;
  }

  private MaterialParameter mtl(String newMtl) {
    mtl = newMtl;
    return this;
  }

  private MaterialParameter of(MaterialParameter... newStrengths) {
    strengths = List.of(newStrengths);
    return this;
  }

  /** Returns all parameters, in the order of their declaration. */
  public static List<MaterialParameter> all() {
    return List.copyOf(ALL);
  }

  /** Returns the extensions of glTF materials that have parameters; see {@link #gltfObject}. */
  public static Set<String> gltfExtensions() {
    Set<String> extensions = new LinkedHashSet<>();
    ALL.forEach(parameter -> extensions.add(parameter.gltfObject));
    extensions.remove(CORE);
    return extensions;
  }

  /** Returns the type of the values. */
  public Kind kind() {
    return kind;
  }

  /** Returns the key in scene files, and the stem of its texture's keys. */
  public String key() {
    return key;
  }

  /** Returns the default: three equal components of a number. */
  public Rgb defaultValue() {
    return defaultValue;
  }

  /** Returns a description for the schema of scene files, without range and default. */
  public String meaning() {
    return meaning;
  }

  /** Returns the smallest number, or component of a color, except the index 0. */
  public double least() {
    return least;
  }

  /** Returns the largest number, or component of a color. */
  public double most() {
    return most;
  }

  /** Returns whether a texture can vary the value over the surface. */
  public boolean isTextured() {
    return !gltfTexture.isEmpty();
  }

  /** Returns the extension of a glTF material, or the object in it, that has the parameter. */
  public String gltfObject() {
    return gltfObject;
  }

  /** Returns the member of {@link #gltfObject} that states a factor; empty if there is none. */
  public String gltfFactor() {
    return gltfFactor;
  }

  /** Returns the member of {@link #gltfObject} that states a texture; empty if there is none. */
  public String gltfTexture() {
    return gltfTexture;
  }

  /** Returns the channel of a number in glTF's texture: 0 to 3 for red, green, blue and alpha. */
  public int gltfChannel() {
    return channel;
  }

  /** Returns the value of a 1 in glTF: 1, except for angles, which are in radians there. */
  public double gltfUnit() {
    return gltfUnit;
  }

  /** Returns the key in material libraries, in lower case; empty if there is none. */
  public String mtl() {
    return mtl;
  }

  /** Returns the parameters that turn this one off if all are 0; this one if there is no other. */
  public List<MaterialParameter> strengths() {
    return strengths;
  }

  /** Returns whether a number, or a component of a color, is in range. */
  public boolean accepts(double value) {
    return value >= least && value <= most || this == IOR && value == 0;
  }

  /** Returns a description of the range for messages. */
  public String expected() {
    if (most > Double.MAX_VALUE) {
      return "a number > 0";
    }
    if (least == 1) {
      return this == IOR ? "0 or 1 to 1e6" : "1 to 1e6";
    }
    return most == Double.MAX_VALUE ? "at least 0" : "0 to 1";
  }

  /**
   * Returns a constant value.
   *
   * @param value three equal components of a number
   * @throws IllegalArgumentException if it is out of range; the message names the parameter, the
   *     expected range and the value
   */
  Channel constant(Rgb value) {
    boolean isColor = kind == Kind.COLOR;
    if (!(accepts(value.r()) && accepts(value.g()) && accepts(value.b()))) {
      throw new IllegalArgumentException(
          key + ": expected " + expected() + ", found " + (isColor ? value : value.r()));
    }
    return isColor ? ColorChannel.of(value) : ScalarChannel.of(value.r());
  }

  /**
   * Returns a value if it suits this parameter.
   *
   * @throws IllegalArgumentException if it is of another kind, or varies without being allowed to
   */
  Channel require(Channel value) {
    boolean suits =
        switch (kind) {
          case COLOR -> value instanceof ColorChannel;
          case NUMBER -> value instanceof ScalarChannel;
          case NORMALS -> value instanceof NormalChannel;
        };
    if (!suits || !isTextured() && !value.isConstant()) {
      throw new IllegalArgumentException(
          key + ": expected " + (isTextured() ? "" : "a constant ") + kind + ", found " + value);
    }
    return value;
  }

  @Override
  public String toString() {
    return key;
  }
}
