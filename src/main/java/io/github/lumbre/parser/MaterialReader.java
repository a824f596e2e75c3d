package io.github.lumbre.parser;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.Emission;
import io.github.lumbre.material.Channel;
import io.github.lumbre.material.CookTorrance;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.MetallicRoughness;
import io.github.lumbre.material.MicrofacetDistribution;
import io.github.lumbre.material.Mirror;
import io.github.lumbre.material.NormalMapped;
import io.github.lumbre.material.Phong;
import io.github.lumbre.material.ShadowCatcher;
import io.github.lumbre.material.Unlit;
import io.github.lumbre.material.internal.ColorChannel;
import io.github.lumbre.material.internal.Dielectric;
import io.github.lumbre.material.internal.NormalChannel;
import io.github.lumbre.material.internal.ScalarChannel;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.texture.Texture;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Reads each material at its first use. */
final class MaterialReader {
  static final double MAX_IOR = 1e6;

  /** The end of a key that names the texture of a channel. */
  private static final String TEXTURE = "TextureId";

  private static final String REPEATED = "multipleScattering";

  private final AssetTable assets;
  private final TextureReader textures;
  private final Map<JsonNode, Surface> surfaces = new HashMap<>();
  private boolean hasGlass;

  /** The material types and their keys. */
  final Family<Function<JsonNode, Surface>> family =
      new Family<Function<JsonNode, Surface>>("materialType", AssetTable.COMMON_KEYS)
          .with("Diffuse", this::diffuse, keys(List.of("color", "normal")))
          .with("Color", this::color, keys(List.of("color")))
          .with("AreaLight", this::areaLight, keys(List.of("color"), "twoSided"))
          .with("Reflective", this::reflective, keys(List.of("reflectivityColor", "normal")))
          .with(
              "Refractive",
              this::refractive,
              keys(
                  List.of("refractionColor", "reflectivityColor", "ior", "normal", "roughness"),
                  REPEATED))
          .with("None", material -> Surface.DEFAULT)
          .with("Phong", this::phong, keys(List.of("color", "specularColor", "exponent", "normal")))
          .with(
              "CookTorrance",
              this::cookTorrance,
              keys(
                  List.of("color", "specularColor", "roughness", "normal", "ior"),
                  "distribution",
                  REPEATED))
          .with("ShadowCatcher", this::shadowCatcher, keys(List.of("color")))
          .with("MetallicRoughness", this::metallicRoughness, metallicRoughnessKeys());

  MaterialReader(AssetTable assets, TextureReader textures) {
    this.assets = assets;
    this.textures = textures;
  }

  /** Returns the scene file keys of these channels and of their textures, and other keys. */
  private static String[] keys(List<String> channels, String... others) {
    Stream<String> all =
        channels.stream()
            .flatMap(
                c ->
                    Stream.of(
                        c.equals("normal") ? c + "Strength" : c,
                        c + TEXTURE,
                        c + "Offset",
                        c + "Scale"));
    return Stream.concat(all, Stream.of(others)).toArray(String[]::new);
  }

  /** Warns of keys that no material type has. */
  void checkAll() {
    assets.all(AssetTable.Type.MATERIAL).forEach(m -> m.warnUnknown(family.keys()));
  }

  /** Returns the surface for an object's {@code materialID}; the default if it names none. */
  Surface of(JsonNode object) {
    Optional<JsonNode> asset = assets.find(object, "materialID", AssetTable.Type.MATERIAL);
    return asset.map(a -> surfaces.computeIfAbsent(a, this::read)).orElse(Surface.DEFAULT);
  }

  /** Returns the material asset of an object; empty if it has none. */
  Optional<JsonNode> asset(JsonNode object) {
    return assets.has(object, "materialID", AssetTable.Type.MATERIAL)
        ? assets.find(object, "materialID", AssetTable.Type.MATERIAL)
        : Optional.empty();
  }

  /** Returns the surface of the material asset with an id that a node states; empty if none. */
  Optional<Surface> named(JsonNode node, String key) {
    return assets
        .find(node, key, AssetTable.Type.MATERIAL)
        .map(a -> surfaces.computeIfAbsent(a, this::read));
  }

  /** Returns whether any object uses a material. */
  boolean uses(JsonNode material) {
    return surfaces.containsKey(material);
  }

  /** Returns the number of materials in use. */
  int count() {
    return surfaces.size();
  }

  /** Returns whether any material in use is glass. */
  boolean hasGlass() {
    return hasGlass;
  }

  private Surface read(JsonNode material) {
    return family.choose(material).map(reader -> reader.apply(material)).orElse(Surface.DEFAULT);
  }

  private Surface diffuse(JsonNode material) {
    return surface(material, new Matte(reflectances(material, "color").get(0)));
  }

  private Surface shadowCatcher(JsonNode material) {
    return surface(material, new ShadowCatcher(reflectances(material, "color").get(0)));
  }

  private Surface color(JsonNode material) {
    Emission emission =
        new Emission(textures.color(material, "color", material.rgb("color")), true);
    return (shape, scene) -> scene.add(shape, Unlit.INSTANCE, emission);
  }

  /** An infinite plane cannot be sampled; it is as one of type Color. */
  private Surface areaLight(JsonNode material) {
    Emission emission =
        new Emission(
            textures.color(material, "color", material.rgb("color")),
            material.flag("twoSided", false));
    return (shape, scene) -> scene.addAreaLight(shape, emission);
  }

  private Surface reflective(JsonNode material) {
    return surface(material, new Mirror(reflectances(material, "reflectivityColor").get(0)));
  }

  private Surface refractive(JsonNode material) {
    hasGlass = true;
    List<Texture<Rgb>> both = reflectances(material, "reflectivityColor", "refractionColor");
    return surface(
        material,
        new Glass(
            both.get(0),
            both.get(1),
            textures.scalar(material, "ior", 1, Dielectric.IOR, 1, MAX_IOR),
            textures.scalar(material, "roughness", 0, Range.FRACTION, 0, 1),
            material.flag(REPEATED, false)));
  }

  private Surface phong(JsonNode material) {
    Rgb color = material.rgb("color");
    Rgb specular = material.rgb("specularColor");
    warnOfSum(material, color.plus(specular));
    return surface(
        material,
        new Phong(
            textures.color(material, "color", color),
            textures.color(material, "specularColor", specular),
            textures.scalar(material, "exponent", 1, Range.NOT_NEGATIVE, 0, Double.MAX_VALUE)));
  }

  private Surface cookTorrance(JsonNode material) {
    Rgb color = material.rgb("color");
    Rgb specular = material.rgb("specularColor");
    warnOfSum(material, color.plus(specular));
    MicrofacetDistribution distribution =
        material.choice("distribution", MicrofacetDistribution.BECKMANN);
    return surface(
        material,
        new CookTorrance(
            textures.color(material, "color", color),
            textures.color(material, "specularColor", specular),
            textures.scalar(material, "roughness", 1, Range.FRACTION, 0, 1),
            textures.scalar(
                material, "ior", CookTorrance.DEFAULT_IOR, Dielectric.IOR, 1, MAX_IOR),
            distribution,
            scattersRepeatedly(material, distribution)));
  }

  private static boolean scattersRepeatedly(JsonNode material, MicrofacetDistribution facets) {
    boolean isStated = material.flag(REPEATED, false);
    if (isStated && facets != MicrofacetDistribution.GGX) {
      material.error(
          REPEATED,
          "expected false with the distribution beckmann, found true; add \"distribution\":"
              + " \"ggx\"");
    }
    return isStated && facets == MicrofacetDistribution.GGX;
  }

  private static String[] metallicRoughnessKeys() {
    Set<String> normals =
        MaterialParameter.all().stream()
            .filter(p -> p.kind() == MaterialParameter.Kind.NORMALS)
            .map(MaterialParameter::key)
            .collect(Collectors.toSet());
    Stream<String> keys =
        MaterialParameter.all().stream()
            .flatMap(p -> p.isTextured() ? Stream.of(keys(List.of(p.key()))) : Stream.of(p.key()))
            .map(key -> normals.contains(key) ? key + "Strength" : key);
    return Stream.of(keys, Stream.of(keys(List.of("normal"))), Stream.of("twoSided"))
        .flatMap(each -> each)
        .toArray(String[]::new);
  }

  private Surface metallicRoughness(JsonNode material) {
    MetallicRoughness.Builder builder = MetallicRoughness.builder();
    for (MaterialParameter parameter : MaterialParameter.all()) {
      Optional<? extends Channel> value =
          switch (parameter.kind()) {
            case COLOR -> Optional.of(color(material, parameter));
            case NUMBER -> Optional.of(number(material, parameter));
            case NORMALS ->
                textures.normalMap(material, parameter.key()).map(map -> new NormalChannel(map, 0));
          };
      if (material.has(parameter.key()) || material.has(parameter.key() + TEXTURE)) {
        value.ifPresent(channel -> builder.set(parameter, channel));
      }
    }
    if (!material.flag("twoSided", true)) {
      builder.singleSided();
    }
    hasGlass |= material.has(MaterialParameter.ATTENUATION_DISTANCE.key());
    return surface(material, builder.build());
  }

  private ColorChannel color(JsonNode material, MaterialParameter parameter) {
    String key = parameter.key();
    Rgb constant = material.has(key) ? material.rgb(key) : parameter.missing();
    if (constant.max() > 1) {
      material.warn(key, "the reflectance exceeds 1; it is clamped to 1");
    }
    return parameter.isTextured()
        ? ColorChannel.of(textures.reflectance(material, key, constant), 0)
        : ColorChannel.of(constant.clampedToOne());
  }

  private ScalarChannel number(JsonNode material, MaterialParameter parameter) {
    double missing = parameter.missing().r();
    if (!parameter.isTextured()) {
      return ScalarChannel.of(material.number(parameter.key(), missing, range(parameter)));
    }
    return ScalarChannel.of(
        textures.scalar(
            material,
            parameter.key(),
            missing,
            range(parameter),
            parameter.least(),
            parameter.most()),
        0);
  }

  static Range range(MaterialParameter parameter) {
    if (parameter == MaterialParameter.ATTENUATION_DISTANCE) {
      return Range.POSITIVE;
    }
    Range closed = Range.closed(parameter.least(), parameter.most());
    return parameter.accepts(0) && !closed.contains(0) ? closed.orZero() : closed;
  }

  /** Returns the surface of a material, with its normal map if it has one. */
  private Surface surface(JsonNode material, Material flat) {
    return Surface.of(
        textures
            .normalMap(material, "normal")
            .<Material>map(map -> new NormalMapped(flat, map))
            .orElse(flat));
  }

  private static void warnOfSum(JsonNode material, Rgb sum) {
    if (sum.max() > 1) {
      material.warn(
          "specularColor", "the sum of color and specularColor exceeds 1; both are scaled down");
    }
  }

  /** Returns channels clamped to a reflectance of 1; adds at most one warning for all of them. */
  private List<Texture<Rgb>> reflectances(JsonNode material, String... channels) {
    List<Texture<Rgb>> found = new ArrayList<>();
    boolean warned = false;
    for (String channel : channels) {
      Rgb constant = material.rgb(channel);
      if (constant.max() > 1 && !warned) {
        material.warn(channel, "the reflectance exceeds 1; it is clamped to 1");
        warned = true;
      }
      found.add(textures.reflectance(material, channel, constant));
    }
    return found;
  }
}
