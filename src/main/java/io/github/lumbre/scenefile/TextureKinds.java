package io.github.lumbre.scenefile;

import io.github.lumbre.math.internal.Range;
import io.github.lumbre.texture.internal.CloudTexture;
import io.github.lumbre.texture.internal.ImageTexture;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import io.github.lumbre.texture.internal.MarbleTexture;
import io.github.lumbre.texture.internal.TexelTexture;
import io.github.lumbre.texture.internal.VoronoiTexture;
import io.github.lumbre.texture.internal.WoodTexture;
import java.util.Optional;
import java.util.function.BiFunction;

/** The textures of scene files. */
final class TextureKinds {
  static final Family<BiFunction<TextureReader, JsonNode, Optional<Picture>>> FAMILY =
      new Family<>("textureType", Optional.of("Image"), "a texture", ObjectKeys.OF_ASSETS);

  static final Key<String> BASE64 = ObjectKeys.content("base64PNG");
  static final Key<Filter> FILTER = Key.choice("filter", Filter.NEAREST, "");
  static final Key<Long> SEED =
      Key.of(
          "seed",
          Value.LONG,
          "Of the random numbers; derived from the scene's seed where missing.");

  private static final Key<Integer> WIDTH = side("width");
  private static final Key<Integer> HEIGHT = side("height");

  static {
    FAMILY
        .kind("Image", ImageTexture.class, TextureReader::image)
        .with(BASE64, ObjectKeys.FILE, FILTER);
    Key<Double> rings = Key.number("rings", WoodTexture.RINGS, 10, "");
    kind("Wood", WoodTexture.class, (t, seed) -> new WoodTexture(seed, w(t), h(t), rings.in(t)))
        .with(rings, WoodTexture::rings)
        .with(SEED, WoodTexture::seed)
        .with(WIDTH, WoodTexture::width)
        .with(HEIGHT, WoodTexture::height);
    kind("Marble", MarbleTexture.class, (t, seed) -> new MarbleTexture(seed, w(t), h(t)))
        .with(SEED, MarbleTexture::seed)
        .with(WIDTH, MarbleTexture::width)
        .with(HEIGHT, MarbleTexture::height);
    Key<Double> density = Key.number("density", Range.FROM_ONE, 128, "");
    kind(
            "Cloud",
            CloudTexture.class,
            (t, seed) -> new CloudTexture(seed, w(t), h(t), density.in(t)))
        .with(density, CloudTexture::density)
        .with(SEED, CloudTexture::seed)
        .with(WIDTH, CloudTexture::width)
        .with(HEIGHT, CloudTexture::height);
    Key<Integer> samples = Key.integer("samples", 1, VoronoiTexture.MAX_SAMPLES, 10, "");
    Key<Boolean> gray = Key.flag("blackAndWhite", false, "");
    kind(
            "Voronoi",
            VoronoiTexture.class,
            (t, seed) -> new VoronoiTexture(seed, w(t), h(t), samples.in(t), gray.in(t)))
        .with(samples, VoronoiTexture::samples)
        .with(gray, VoronoiTexture::isBlackAndWhite)
        .with(SEED, VoronoiTexture::seed)
        .with(WIDTH, VoronoiTexture::width)
        .with(HEIGHT, VoronoiTexture::height);
  }

  private TextureKinds() {}

  /** Makes a texture of an asset, and the seed of its random numbers. */
  private interface Formula {
    TexelTexture texture(JsonNode asset, long seed);
  }

  private static <O extends TexelTexture>
      Kind<BiFunction<TextureReader, JsonNode, Optional<Picture>>, O> kind(
          String name, Class<O> type, Formula formula) {
    return FAMILY
        .kind(
            name,
            type,
            (reader, asset) ->
                reader.computed(asset, formula.texture(asset, reader.seedOf(asset))))
        .with(FILTER);
  }

  private static Key<Integer> side(String name) {
    return Key.integer(name, 1, TexelTexture.MAX_SIDE, 1000, "Texels.");
  }

  private static int w(JsonNode texture) {
    return WIDTH.in(texture);
  }

  private static int h(JsonNode texture) {
    return HEIGHT.in(texture);
  }
}
