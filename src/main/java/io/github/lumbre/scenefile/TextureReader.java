package io.github.lumbre.scenefile;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.camera.Aperture;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.sampling.internal.Hash;
import io.github.lumbre.scenefile.AssetTable.Type;
import io.github.lumbre.scenefile.LightKinds.Sky;
import io.github.lumbre.scenefile.internal.Origin;
import io.github.lumbre.scenefile.internal.SceneOrigins.TextureUse;
import io.github.lumbre.texture.NormalMap;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.UvMapping;
import io.github.lumbre.texture.internal.ClearSky;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import io.github.lumbre.texture.internal.ImageTexture.Role;
import io.github.lumbre.texture.internal.RedChannel;
import io.github.lumbre.texture.internal.StudioSky;
import io.github.lumbre.texture.internal.TexelTexture;
import io.github.lumbre.texture.internal.TintedTexture;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Reads each texture at its first use, and the material channels that use textures. */
final class TextureReader {
  private static final List<Key<Double>> SUN_KEYS =
      List.of(LightKinds.SUN_AZIMUTH, LightKinds.SUN_ELEVATION);

  private final AssetTable assets;
  private final AssetData data;
  private final TextureChange change;
  private final long seed;
  private final Map<JsonNode, Optional<Picture>> pictures = new HashMap<>();
  private final Map<Point2, ClearSky> clearSkies = new HashMap<>();
  private final List<TextureUse> uses = new ArrayList<>();

  /**
   * @param seed seed of the scene; with their ids, it determines procedural textures
   */
  TextureReader(AssetTable assets, AssetData data, long seed, TextureChange change) {
    this.assets = assets;
    this.data = data;
    this.change = change;
    this.seed = seed;
  }

  /** Returns the uses of decoded images by materials so far. */
  List<TextureUse> uses() {
    return uses;
  }

  /** Finds the texture of a material's channel, and records the use. */
  private Optional<Picture> find(JsonNode material, Key<?> key, UvMapping mapping) {
    if (key.variation().isEmpty()) {
      return Optional.empty();
    }
    Optional<Picture> picture = find(material, key.texture());
    if (picture.isPresent() && picture.get() instanceof Picture.Decoded decoded) {
      Origin texture =
          assets.findSilently(material, key.texture(), Type.TEXTURE).orElseThrow().origin();
      uses.add(
          new TextureUse(
              material.origin(),
              key.stem(),
              texture,
              decoded.width(),
              decoded.height(),
              mapping.scaleX(),
              mapping.scaleY()));
    }
    return picture;
  }

  private Optional<Picture> find(JsonNode from, Key<Integer> key) {
    return assets
        .find(from, key, Type.TEXTURE)
        .flatMap(asset -> pictures.computeIfAbsent(asset, this::read));
  }

  private Optional<Picture> read(JsonNode texture) {
    Interrupts.check();
    return TextureKinds.FAMILY.choose(texture).flatMap(reader -> reader.apply(this, texture));
  }

  /** Returns the picture of an asset; empty, with an error added, if it cannot be decoded. */
  Optional<Picture> image(JsonNode texture) {
    Filter filter = filter(texture);
    return data.read(texture, TextureKinds.BASE64)
        .flatMap(
            content ->
                new PictureDecoder(data.allowance(), assets.isLenient()).read(content, filter));
  }

  /** Returns a texture that is computed. */
  Optional<Picture> computed(JsonNode texture, TexelTexture texels) {
    return Optional.of(new Picture.Computed(texels, filter(texture)));
  }

  /** Returns the texture's own seed; without one, it depends on the scene's and on the id. */
  long seedOf(JsonNode texture) {
    long derived = Hash.of(Hash.mix(seed), ObjectKeys.ID.in(texture, AssetTable.NONE));
    return TextureKinds.SEED.in(texture, derived);
  }

  private Filter filter(JsonNode texture) {
    return change.filter(TextureKinds.FILTER.in(texture));
  }

  private Texture<Rgb> watched(Picture picture, Role role) {
    return change.watched(picture.as(role));
  }

  /** Returns a color of a material: a constant, multiplied by a texture if there is one. */
  Texture<Rgb> color(JsonNode material, Key<Rgb> key, Rgb constant) {
    UvMapping mapping = mapping(material, key);
    return find(material, key, mapping)
        .map(picture -> mapping.over(TintedTexture.of(constant, watched(picture, Role.COLOR))))
        .orElse(Texture.constant(constant));
  }

  /** Returns a color clamped to 1: a constant here, a texture at each lookup. */
  Texture<Rgb> reflectance(JsonNode material, Key<Rgb> key, Rgb constant) {
    boolean isTextured =
        key.variation().isPresent()
            && assets.findSilently(material, key.texture(), Type.TEXTURE).isPresent();
    return color(material, key, isTextured ? constant : constant.clampedToOne());
  }

  /** Returns a number: a constant, multiplied by a texture's red channel if there is one. */
  ScalarTexture number(JsonNode material, Key<Double> key) {
    double constant = key.in(material);
    UvMapping mapping = mapping(material, key);
    Optional<Picture> picture = find(material, key, mapping);
    if (picture.isEmpty()) {
      return ScalarTexture.constant(constant);
    }
    double low = key.variation().orElseThrow().low();
    double high = key.variation().orElseThrow().high();
    return new RedChannel(mapping.over(watched(picture.get(), Role.DATA)), constant, low, high);
  }

  /** Returns the normal map of a key, or empty if it has none. */
  Optional<NormalMap> normalMap(JsonNode material, Key<Double> key) {
    double strength = key.in(material);
    UvMapping mapping = mapping(material, key);
    return find(material, key, mapping)
        .map(picture -> new NormalMap(watched(picture, Role.NORMAL), mapping, strength));
  }

  private static UvMapping mapping(JsonNode material, Key<?> key) {
    if (key.variation().isEmpty()) {
      return UvMapping.IDENTITY;
    }
    Point2 offset = key.offset().in(material);
    Point2 scale = key.scale().in(material);
    return new UvMapping(offset.x(), offset.y(), scale.x(), scale.y());
  }

  /** Returns an environment light of constant radiance, multiplied by an image if there is one. */
  EnvironmentLight dome(JsonNode light, Frame axes, Rgb radiance) {
    Optional<Sky> sky = LightKinds.SKY.stated(light);
    if (sky.isEmpty() || sky.get() == Sky.STUDIO || sky.get() == Sky.RELIEF) {
      SUN_KEYS.stream()
          .filter(key -> key.isIn(light))
          .forEach(key -> key.warn(light, "is ignored, because only clear and sun have a sun"));
    }
    if (sky.isPresent()) {
      return switch (sky.get()) {
        case STUDIO -> change.studio(axes, radiance, StudioSky.SOFT);
        case RELIEF -> change.studio(axes, radiance, StudioSky.RELIEF);
        case CLEAR -> change.clear(axes, radiance, clearSky(light));
        case SUN -> change.sun(axes, radiance, clearSky(light));
      };
    }
    return find(light, LightKinds.TEXTURE)
        .map(picture -> change.dome(axes, radiance, picture))
        .orElse(EnvironmentLight.uniform(radiance));
  }

  /** Returns the sky of a place of the sun; lights with the same place share it. */
  private ClearSky clearSky(JsonNode light) {
    double azimuth = LightKinds.SUN_AZIMUTH.in(light);
    double elevation = LightKinds.SUN_ELEVATION.in(light);
    return clearSkies.computeIfAbsent(
        new Point2(azimuth, elevation), sun -> new ClearSky(sun.x(), sun.y()));
  }

  /** Returns the aperture that a mask describes: white is open. Empty if there is no mask. */
  Optional<Aperture> mask(JsonNode camera, Key<Integer> key) {
    return find(camera, key).flatMap(picture -> mask(camera, key.name(), picture));
  }

  private static Optional<Aperture> mask(JsonNode camera, String key, Picture picture) {
    boolean[][] white = new boolean[picture.height()][picture.width()];
    boolean any = false;
    boolean gray = false;
    for (int y = 0; y < picture.height(); y++) {
      for (int x = 0; x < picture.width(); x++) {
        double value = picture.value(x, y);
        gray |= value > 0 && value < 1;
        any |= value >= .5;
        // Images store the top row first, apertures the bottom row.
        white[picture.height() - 1 - y][x] = value >= .5;
      }
    }
    if (gray) {
      camera.warn(key, "the mask is not black and white; values from 0.5 up count as white");
    }
    if (!any) {
      camera.error(key, "expected a mask with white pixels, found none");
      return Optional.empty();
    }
    return Optional.of(Aperture.mask(white));
  }
}
