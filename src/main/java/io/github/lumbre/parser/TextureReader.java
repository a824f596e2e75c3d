package io.github.lumbre.parser;

import io.github.lumbre.camera.Aperture;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.limit.internal.Interrupts;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.parser.AssetTable.Type;
import io.github.lumbre.parser.internal.SceneOrigins.TextureUse;
import io.github.lumbre.texture.NormalMap;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.UvMapping;
import io.github.lumbre.texture.internal.ClearSky;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import io.github.lumbre.texture.internal.ImageTexture.Role;
import io.github.lumbre.texture.internal.RedChannel;
import io.github.lumbre.texture.internal.TexelTexture;
import io.github.lumbre.texture.internal.TintedTexture;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;

/** Reads each texture at its first use, and the material channels that use textures. */
final class TextureReader {
  private static final String BASE64_KEY = "base64PNG";

  private static final Point2 NO_OFFSET = new Point2(0, 0);
  private static final Point2 NO_SCALE = new Point2(1, 1);

  /** The keys of the sun's place: its azimuth and its elevation. */
  private static final List<String> SUN_KEYS = List.of("sunAzimuth", "sunElevation");

  private enum Sky {
    STUDIO,
    CLEAR,
    SUN
  }

  private final AssetTable assets;
  private final AssetData data;
  private final TextureChange change;
  private final ProceduralReader procedurals;
  private final Map<JsonNode, Optional<Picture>> pictures = new HashMap<>();
  private final Map<Point2, ClearSky> clearSkies = new HashMap<>();
  private final List<TextureUse> uses = new ArrayList<>();

  /** The texture types and their keys. */
  final Family<Function<JsonNode, Optional<Picture>>> family =
      new Family<Function<JsonNode, Optional<Picture>>>("textureType", AssetTable.COMMON_KEYS)
          .with("Image", this::image, BASE64_KEY, AssetData.FILE_KEY, "filter")
          .with(
              "Wood", t -> computed(t, ProceduralReader::wood), "width", "height", "rings", "seed")
          .with("Marble", t -> computed(t, ProceduralReader::marble), "width", "height", "seed")
          .with(
              "Cloud",
              t -> computed(t, ProceduralReader::cloud),
              "width",
              "height",
              "density",
              "seed")
          .with(
              "Voronoi",
              t -> computed(t, ProceduralReader::voronoi),
              "width",
              "height",
              "samples",
              "blackAndWhite",
              "seed");

  /**
   * @param seed seed of the scene; with their ids, it determines procedural textures
   */
  TextureReader(AssetTable assets, AssetData data, long seed, TextureChange change) {
    this.assets = assets;
    this.data = data;
    this.change = change;
    procedurals = new ProceduralReader(seed);
  }

  /** Warns of keys that no texture type has. */
  void checkAll() {
    assets.all(Type.TEXTURE).forEach(t -> t.warnUnknown(family.keys()));
  }

  /** Returns the number of textures in use. */
  int count() {
    return pictures.size();
  }

  /** Returns whether any material, light or camera uses a texture. */
  boolean uses(JsonNode texture) {
    return pictures.containsKey(texture);
  }

  /** Returns the uses of decoded images by materials so far. */
  List<TextureUse> uses() {
    return uses;
  }

  /** Finds the texture of a material's channel, and records the use. */
  private Optional<Picture> find(JsonNode material, String channel, UvMapping mapping) {
    String key = channel + "TextureId";
    Optional<Picture> picture = find(material, key);
    if (picture.isPresent() && picture.get() instanceof Picture.Decoded decoded) {
      assets
          .find(material, key, Type.TEXTURE)
          .ifPresent(
              texture ->
                  uses.add(
                      new TextureUse(
                          material.origin(),
                          channel,
                          texture.origin(),
                          decoded.width(),
                          decoded.height(),
                          mapping.scaleX(),
                          mapping.scaleY())));
    }
    return picture;
  }

  private Optional<Picture> find(JsonNode from, String key) {
    return assets
        .find(from, key, Type.TEXTURE)
        .flatMap(asset -> pictures.computeIfAbsent(asset, this::read));
  }

  private Optional<Picture> read(JsonNode texture) {
    Interrupts.check();
    return family.choose(texture, "Image").flatMap(reader -> reader.apply(texture));
  }

  private Optional<Picture> image(JsonNode texture) {
    Filter filter = filter(texture);
    return data.read(texture, BASE64_KEY)
        .flatMap(
            content ->
                new PictureDecoder(data.allowance(), assets.isLenient()).read(content, filter));
  }

  private Optional<Picture> computed(
      JsonNode texture, BiFunction<ProceduralReader, JsonNode, TexelTexture> reader) {
    TexelTexture texels = reader.apply(procedurals, texture);
    return Optional.of(new Picture.Computed(texels, filter(texture)));
  }

  private Filter filter(JsonNode texture) {
    return change.filter(texture.choice("filter", Filter.NEAREST));
  }

  private Texture<Rgb> watched(Picture picture, Role role) {
    return change.watched(picture.as(role));
  }

  /**
   * Returns a color channel of a material: a constant, multiplied by a texture if there is one.
   *
   * @param constant the channel's constant color
   */
  Texture<Rgb> color(JsonNode material, String channel, Rgb constant) {
    UvMapping mapping = mapping(material, channel);
    return find(material, channel, mapping)
        .map(picture -> mapping.over(TintedTexture.of(constant, watched(picture, Role.COLOR))))
        .orElse(Texture.constant(constant));
  }

  /** Returns a color channel clamped to 1: a constant here, a texture at each lookup. */
  Texture<Rgb> reflectance(JsonNode material, String channel, Rgb constant) {
    boolean textured = assets.has(material, channel + "TextureId", Type.TEXTURE);
    return color(material, channel, textured ? constant : constant.clampedToOne());
  }

  /**
   * Returns a scalar channel: a constant, multiplied by a texture's red channel if there is one.
   *
   * @param missing constant if the key is missing
   * @param range valid range of the constant
   * @param low lower limit of the product with the texture
   * @param high upper limit of the product with the texture
   */
  ScalarTexture scalar(
      JsonNode material, String channel, double missing, Range range, double low, double high) {
    double constant = material.number(channel, missing, range);
    UvMapping mapping = mapping(material, channel);
    Optional<Picture> picture = find(material, channel, mapping);
    if (picture.isEmpty()) {
      return ScalarTexture.constant(constant);
    }
    return new RedChannel(mapping.over(watched(picture.get(), Role.DATA)), constant, low, high);
  }

  /** Returns the normal map of a channel, or empty if it has none. */
  Optional<NormalMap> normalMap(JsonNode material, String channel) {
    double strength = material.number(channel + "Strength", 1, Range.ANY);
    UvMapping mapping = mapping(material, channel);
    return find(material, channel, mapping)
        .map(picture -> new NormalMap(watched(picture, Role.NORMAL), mapping, strength));
  }

  private static UvMapping mapping(JsonNode material, String channel) {
    Point2 offset = material.vec2(channel + "Offset", NO_OFFSET);
    Point2 scale = material.vec2(channel + "Scale", NO_SCALE);
    return new UvMapping(offset.x(), offset.y(), scale.x(), scale.y());
  }

  /** Returns an environment light of constant radiance, multiplied by an image if there is one. */
  EnvironmentLight dome(JsonNode light, Frame axes, Rgb radiance) {
    Optional<Sky> sky =
        light.has("sky") ? Optional.of(light.choice("sky", Sky.STUDIO)) : Optional.empty();
    if (sky.isEmpty() || sky.get() == Sky.STUDIO) {
      SUN_KEYS.stream()
          .filter(light::has)
          .forEach(key -> light.warn(key, "is ignored, because only clear and sun have a sun"));
    }
    if (sky.isPresent()) {
      return switch (sky.get()) {
        case STUDIO -> change.studio(axes, radiance);
        case CLEAR -> change.clear(axes, radiance, clearSky(light));
        case SUN -> change.sun(axes, radiance, clearSky(light));
      };
    }
    return find(light, "textureId")
        .map(picture -> change.dome(axes, radiance, picture))
        .orElse(EnvironmentLight.uniform(radiance));
  }

  /** Returns the sky of a place of the sun; lights with the same place share it. */
  private ClearSky clearSky(JsonNode light) {
    double azimuth = light.number(SUN_KEYS.get(0), Stage.Sky.SUN.azimuth(), Range.ANY);
    double elevation =
        light.number(SUN_KEYS.get(1), Stage.Sky.SUN.elevation(), Range.closed(ClearSky.LOWEST, 90));
    return clearSkies.computeIfAbsent(
        new Point2(azimuth, elevation), sun -> new ClearSky(sun.x(), sun.y()));
  }

  /** Returns the aperture that a mask describes: white is open. Empty if there is no mask. */
  Optional<Aperture> mask(JsonNode camera, String key) {
    return find(camera, key).flatMap(picture -> mask(camera, key, picture));
  }

  private static Optional<Aperture> mask(JsonNode camera, String key, Picture picture) {
    boolean[][] white = new boolean[picture.height()][picture.width()];
    boolean any = false;
    boolean grey = false;
    for (int y = 0; y < picture.height(); y++) {
      for (int x = 0; x < picture.width(); x++) {
        double value = picture.value(x, y);
        grey |= value > 0 && value < 1;
        any |= value >= .5;
        // Images store the top row first, apertures the bottom row.
        white[picture.height() - 1 - y][x] = value >= .5;
      }
    }
    if (grey) {
      camera.warn(key, "the mask is not black and white; values from 0.5 up count as white");
    }
    if (!any) {
      camera.error(key, "expected a mask with white pixels, found none");
      return Optional.empty();
    }
    return Optional.of(Aperture.mask(white));
  }
}
