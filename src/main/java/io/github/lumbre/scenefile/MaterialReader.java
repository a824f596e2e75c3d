package io.github.lumbre.scenefile;

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
import io.github.lumbre.material.internal.NormalChannel;
import io.github.lumbre.material.internal.ScalarChannel;
import io.github.lumbre.texture.Texture;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Reads each material at its first use. */
final class MaterialReader {
  private final AssetTable assets;
  private final TextureReader textures;
  private final Map<JsonNode, Surface> surfaces = new HashMap<>();
  private boolean hasGlass;

  MaterialReader(AssetTable assets, TextureReader textures) {
    this.assets = assets;
    this.textures = textures;
  }

  /** Warns of keys that no material type has. */
  void checkAll() {
    assets.all(AssetTable.Type.MATERIAL).forEach(m -> m.warnUnknown(MaterialKinds.FAMILY.keys()));
  }

  /** Returns the surface for an object's {@code materialID}; the default if it names none. */
  Surface of(JsonNode object) {
    Optional<JsonNode> asset = assets.find(object, ShapeKinds.MATERIAL, AssetTable.Type.MATERIAL);
    return asset.map(a -> surfaces.computeIfAbsent(a, this::read)).orElse(Surface.DEFAULT);
  }

  /** Returns the material asset of an object; empty if it has none. */
  Optional<JsonNode> asset(JsonNode object) {
    return assets.has(object, ShapeKinds.MATERIAL, AssetTable.Type.MATERIAL)
        ? assets.find(object, ShapeKinds.MATERIAL, AssetTable.Type.MATERIAL)
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
    return MaterialKinds.FAMILY
        .choose(material)
        .map(reader -> reader.apply(this, material))
        .orElse(Surface.DEFAULT);
  }

  Surface diffuse(JsonNode material) {
    return surface(material, new Matte(reflectances(material, MaterialKinds.COLOR).get(0)));
  }

  Surface shadowCatcher(JsonNode material) {
    return surface(material, new ShadowCatcher(reflectances(material, MaterialKinds.COLOR).get(0)));
  }

  Surface color(JsonNode material) {
    Emission emission = new Emission(color(material, MaterialKinds.COLOR), true);
    return (shape, scene) -> scene.add(shape, Unlit.INSTANCE, emission);
  }

  /** An infinite plane cannot be sampled; it is as one of type Color. */
  Surface areaLight(JsonNode material) {
    Emission emission =
        new Emission(
            color(material, MaterialKinds.COLOR), MaterialKinds.EMITS_INSIDE.in(material));
    return (shape, scene) -> scene.addAreaLight(shape, emission);
  }

  private Texture<Rgb> color(JsonNode material, ChannelKeys<Rgb> channel) {
    return textures.color(material, channel, channel.constant().in(material));
  }

  Surface reflective(JsonNode material) {
    return surface(material, new Mirror(reflectances(material, MaterialKinds.REFLECTED).get(0)));
  }

  Surface refractive(JsonNode material) {
    hasGlass = true;
    List<Texture<Rgb>> both =
        reflectances(material, MaterialKinds.REFLECTED, MaterialKinds.REFRACTED);
    return surface(
        material,
        new Glass(
            both.get(0),
            both.get(1),
            textures.scalar(material, MaterialKinds.GLASS_IOR),
            textures.scalar(material, MaterialKinds.GLASS_ROUGHNESS),
            MaterialKinds.MULTIPLE_SCATTERING.in(material)));
  }

  Surface phong(JsonNode material) {
    Rgb color = MaterialKinds.COLOR.constant().in(material);
    Rgb specular = MaterialKinds.SPECULAR.constant().in(material);
    warnOfSum(material, color.plus(specular));
    return surface(
        material,
        new Phong(
            textures.color(material, MaterialKinds.COLOR, color),
            textures.color(material, MaterialKinds.SPECULAR, specular),
            textures.scalar(material, MaterialKinds.EXPONENT)));
  }

  Surface cookTorrance(JsonNode material) {
    Rgb color = MaterialKinds.COLOR.constant().in(material);
    Rgb specular = MaterialKinds.SPECULAR.constant().in(material);
    warnOfSum(material, color.plus(specular));
    MicrofacetDistribution distribution = MaterialKinds.DISTRIBUTION.in(material);
    return surface(
        material,
        new CookTorrance(
            textures.color(material, MaterialKinds.COLOR, color),
            textures.color(material, MaterialKinds.SPECULAR, specular),
            textures.scalar(material, MaterialKinds.GLOSS_ROUGHNESS),
            textures.scalar(material, MaterialKinds.GLOSS_IOR),
            distribution,
            scattersRepeatedly(material, distribution)));
  }

  private static boolean scattersRepeatedly(JsonNode material, MicrofacetDistribution facets) {
    boolean isStated = MaterialKinds.MULTIPLE_SCATTERING.in(material);
    if (isStated && facets != MicrofacetDistribution.GGX) {
      material.error(
          MaterialKinds.MULTIPLE_SCATTERING.name(),
          "expected false with the distribution beckmann, found true; add \"distribution\":"
              + " \"ggx\"");
    }
    return isStated && facets == MicrofacetDistribution.GGX;
  }

  Surface metallicRoughness(JsonNode material) {
    MetallicRoughness.Builder builder = MetallicRoughness.builder();
    MaterialKinds.PARAMETERS.forEach(
        (parameter, keys) -> {
          Optional<Channel> value = channel(material, parameter, keys);
          if (keys.isIn(material)) {
            value.ifPresent(channel -> builder.set(parameter, channel));
          }
        });
    if (!MaterialKinds.TWO_SIDED.in(material)) {
      builder.singleSided();
    }
    hasGlass |= material.has(MaterialParameter.ATTENUATION_DISTANCE.key());
    return surface(material, builder.build());
  }

  @SuppressWarnings("unchecked") // The keys have the kind of the parameter.
  private Optional<Channel> channel(
      JsonNode material, MaterialParameter parameter, ChannelKeys<?> keys) {
    return switch (parameter.kind()) {
      case COLOR ->
          Optional.of(reflectance(material, (ChannelKeys<Rgb>) keys, parameter.isTextured()));
      case NUMBER ->
          Optional.of(
              parameter.isTextured()
                  ? ScalarChannel.of(textures.scalar(material, (ChannelKeys<Double>) keys), 0)
                  : ScalarChannel.of((Double) keys.constant().in(material)));
      case NORMALS ->
          textures
              .normalMap(material, (ChannelKeys<Double>) keys)
              .map(map -> new NormalChannel(map, 0));
    };
  }

  private ColorChannel reflectance(
      JsonNode material, ChannelKeys<Rgb> channel, boolean isTextured) {
    Rgb constant = channel.constant().in(material);
    warnOfExcess(material, channel, constant);
    return isTextured
        ? ColorChannel.of(textures.reflectance(material, channel, constant), 0)
        : ColorChannel.of(constant.clampedToOne());
  }

  /** Returns the surface of a material, with its normal map if it has one. */
  private Surface surface(JsonNode material, Material flat) {
    return Surface.of(
        textures
            .normalMap(material, MaterialKinds.NORMAL)
            .<Material>map(map -> new NormalMapped(flat, map))
            .orElse(flat));
  }

  private static void warnOfSum(JsonNode material, Rgb sum) {
    if (sum.max() > 1) {
      material.warn(
          MaterialKinds.SPECULAR.name(),
          "the sum of color and specularColor exceeds 1; both are scaled down");
    }
  }

  /** Adds a warning if a reflectance exceeds 1; returns whether it does. */
  private static boolean warnOfExcess(
      JsonNode material, ChannelKeys<Rgb> channel, Rgb reflectance) {
    if (reflectance.max() > 1) {
      material.warn(channel.name(), "the reflectance exceeds 1; it is clamped to 1");
    }
    return reflectance.max() > 1;
  }

  /** Returns channels clamped to a reflectance of 1; adds at most one warning for all of them. */
  @SafeVarargs
  private List<Texture<Rgb>> reflectances(JsonNode material, ChannelKeys<Rgb>... channels) {
    List<Texture<Rgb>> found = new ArrayList<>();
    boolean warned = false;
    for (ChannelKeys<Rgb> channel : channels) {
      Rgb constant = channel.constant().in(material);
      warned = warned || warnOfExcess(material, channel, constant);
      found.add(textures.reflectance(material, channel, constant));
    }
    return found;
  }
}
