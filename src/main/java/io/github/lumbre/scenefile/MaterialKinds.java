package io.github.lumbre.scenefile;

import com.google.gson.JsonObject;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.Emission;
import io.github.lumbre.material.Channel;
import io.github.lumbre.material.CookTorrance;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.MetallicRoughness;
import io.github.lumbre.material.MicrofacetDistribution;
import io.github.lumbre.material.Mirror;
import io.github.lumbre.material.Phong;
import io.github.lumbre.material.ShadowCatcher;
import io.github.lumbre.material.internal.ColorChannel;
import io.github.lumbre.material.internal.Dielectric;
import io.github.lumbre.material.internal.NormalChannel;
import io.github.lumbre.material.internal.ScalarChannel;
import io.github.lumbre.math.internal.Range;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;

/** The materials of scene files. */
final class MaterialKinds {
  static final Family<BiFunction<MaterialReader, JsonNode, Surface>> FAMILY =
      new Family<>("materialType", Optional.empty(), "a material", ObjectKeys.OF_ASSETS);

  static final ChannelKeys<Rgb> COLOR =
      ChannelKeys.color("color", "What the surface scatters or emits, linear; times the texture.");
  static final ChannelKeys<Double> NORMAL =
      ChannelKeys.normals("normal", "By which the map's slopes are multiplied.");
  static final ChannelKeys<Rgb> SPECULAR =
      ChannelKeys.color("specularColor", "What the gloss reflects, linear.");
  static final ChannelKeys<Rgb> REFLECTED =
      ChannelKeys.color("reflectivityColor", "What is reflected, linear.");
  static final ChannelKeys<Rgb> REFRACTED =
      ChannelKeys.color("refractionColor", "What passes, linear.");
  static final ChannelKeys<Double> EXPONENT =
      ChannelKeys.number(
          Key.number("exponent", Range.NOT_NEGATIVE, 1, "Of the gloss."), 0, Double.MAX_VALUE);
  static final ChannelKeys<Double> GLASS_IOR = ior(1);
  static final ChannelKeys<Double> GLOSS_IOR = ior(CookTorrance.DEFAULT_IOR);
  static final ChannelKeys<Double> GLASS_ROUGHNESS = roughness(0);
  static final ChannelKeys<Double> GLOSS_ROUGHNESS = roughness(1);
  static final Key<MicrofacetDistribution> DISTRIBUTION =
      Key.choice("distribution", MicrofacetDistribution.BECKMANN, "");
  static final Key<Boolean> MULTIPLE_SCATTERING =
      Key.flag(
              "multipleScattering",
              false,
              "Whether light that hits more than one facet is kept; with ggx only.")
          .omitted();
  static final Key<Boolean> EMITS_INSIDE =
      Key.flag("twoSided", false, "Whether the inside emits as well.");
  static final Key<Boolean> TWO_SIDED =
      Key.flag("twoSided", true, "Whether back faces are visible.").omitted();

  /** The channels of the parameters of metallic-roughness; the constants of some are all. */
  static final Map<MaterialParameter, ChannelKeys<?>> PARAMETERS = new LinkedHashMap<>();

  /** A surface that emits light and does not scatter any. */
  static final Kind<BiFunction<MaterialReader, JsonNode, Surface>, Emission> EMISSIVE;

  /** An area light. */
  static final Kind<BiFunction<MaterialReader, JsonNode, Surface>, Emission> AREA_LIGHT;

  static {
    FAMILY
        .kind("Diffuse", Matte.class, MaterialReader::diffuse)
        .color(COLOR, Matte::albedo)
        .with(NORMAL);
    EMISSIVE =
        FAMILY
            .kind("Color", Emission.class, MaterialReader::color)
            .color(COLOR, Emission::radiance);
    AREA_LIGHT =
        FAMILY
            .kind("AreaLight", Emission.class, MaterialReader::areaLight)
            .with(EMITS_INSIDE, Emission::twoSided)
            .color(COLOR, Emission::radiance);
    FAMILY
        .kind("Reflective", Mirror.class, MaterialReader::reflective)
        .color(REFLECTED, Mirror::reflectance)
        .with(NORMAL);
    FAMILY
        .kind("Refractive", Glass.class, MaterialReader::refractive)
        .color(REFLECTED, Glass::reflectance)
        .color(REFRACTED, Glass::transmittance)
        .number(GLASS_IOR, Glass::ior)
        .number(GLASS_ROUGHNESS, Glass::roughness)
        .with(MULTIPLE_SCATTERING, Glass::multipleScattering)
        .with(NORMAL);
    FAMILY.kind("None", Void.class, (reader, material) -> Surface.DEFAULT);
    FAMILY
        .kind("Phong", Phong.class, MaterialReader::phong)
        .color(COLOR, Phong::diffuse)
        .color(SPECULAR, Phong::specular)
        .number(EXPONENT, Phong::exponent)
        .with(NORMAL);
    FAMILY
        .kind("CookTorrance", CookTorrance.class, MaterialReader::cookTorrance)
        .color(COLOR, CookTorrance::diffuse)
        .color(SPECULAR, CookTorrance::specular)
        .number(GLOSS_ROUGHNESS, CookTorrance::roughness)
        .number(GLOSS_IOR, CookTorrance::ior)
        .with(DISTRIBUTION, CookTorrance::distribution)
        .with(MULTIPLE_SCATTERING, CookTorrance::multipleScattering)
        .with(NORMAL);
    FAMILY
        .kind("ShadowCatcher", ShadowCatcher.class, MaterialReader::shadowCatcher)
        .color(COLOR, catcher -> catcher.surface().albedo());
    metallicRoughness();
    FAMILY.refuse("Unlit", "a material of the format", "Unlit");
    FAMILY.refuse("UniformMaterial", "a material of the format", "UniformMaterial");
  }

  private MaterialKinds() {}

  private static ChannelKeys<Double> ior(double missing) {
    return ChannelKeys.number(
        Key.number("ior", Dielectric.IOR, missing, "Index of refraction."),
        1,
        Dielectric.IOR.high());
  }

  private static ChannelKeys<Double> roughness(double missing) {
    return ChannelKeys.number(
        Key.number("roughness", Range.FRACTION, missing, "From smooth to rough."), 0, 1);
  }

  private static void metallicRoughness() {
    Class<MetallicRoughness> type = MetallicRoughness.class;
    Kind<?, MetallicRoughness> kind =
        FAMILY.kind("MetallicRoughness", type, MaterialReader::metallicRoughness);
    for (MaterialParameter parameter : MaterialParameter.all()) {
      ChannelKeys<?> keys = keys(parameter);
      PARAMETERS.put(parameter, keys);
      if (parameter.isTextured()) {
        kind.with(keys);
      } else {
        kind.with(keys.constant());
      }
      kind.writing(
          (material, to, textures) ->
              material.stated(parameter).ifPresent(value -> put(to, parameter, value, textures)));
    }
    kind.with(TWO_SIDED, MetallicRoughness::isDoubleSided).with(NORMAL);
  }

  private static ChannelKeys<?> keys(MaterialParameter parameter) {
    String key = parameter.key();
    return switch (parameter.kind()) {
      case COLOR -> ChannelKeys.color(key, parameter.missing(), parameter.meaning());
      case NORMALS -> ChannelKeys.normals(key, parameter.meaning());
      case NUMBER ->
          ChannelKeys.number(
              Key.number(key, range(parameter), parameter.missing().r(), parameter.meaning()),
              parameter.least(),
              parameter.most());
    };
  }

  private static Range range(MaterialParameter parameter) {
    if (parameter == MaterialParameter.ATTENUATION_DISTANCE) {
      return Range.POSITIVE;
    }
    Range closed = Range.closed(parameter.least(), parameter.most());
    return parameter.accepts(0) && !closed.contains(0) ? closed.orZero() : closed;
  }

  @SuppressWarnings("unchecked") // The channel has the kind of the parameter.
  private static void put(
      JsonObject to, MaterialParameter parameter, Channel value, WrittenTextures textures) {
    ChannelKeys<?> keys = PARAMETERS.get(parameter);
    if (value instanceof ColorChannel.Textured color && color.uvSet() == 0) {
      textures.color(to, (ChannelKeys<Rgb>) keys, color.texture());
    } else if (value instanceof ScalarChannel.Textured number && number.uvSet() == 0) {
      textures.scalar(to, (ChannelKeys<Double>) keys, number.texture());
    } else if (value instanceof NormalChannel normals && normals.uvSet() == 0) {
      textures.normalMap(to, (ChannelKeys<Double>) keys, normals.map());
    } else {
      throw new Unwritable(
          parameter + ": a texture with the first texture coordinates", Written.name(value));
    }
  }
}
