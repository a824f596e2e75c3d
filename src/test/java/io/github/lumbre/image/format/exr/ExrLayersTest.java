package io.github.lumbre.image.format.exr;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.withinPercentage;

import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.ImageLayer.Precision;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.ImageWriter.Options;
import io.github.lumbre.image.LayeredImage;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.image.internal.Cryptomatte;
import io.github.lumbre.image.internal.LinearReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests OpenEXR files with layers. */
class ExrLayersTest {
  private static final int WIDTH = 37;
  private static final int HEIGHT = 35;

  @TempDir private Path folder;

  private static float[] values(int count, long seed) {
    Random random = new Random(seed);
    float[] values = new float[count * WIDTH * HEIGHT];
    for (int i = 0; i < values.length; i++) {
      values[i] = (float) random.nextGaussian();
    }
    return values;
  }

  private static Image picture() {
    return new Image(WIDTH, HEIGHT, values(3, 1), new float[0]);
  }

  private static ImageLayer layer(String name, String channels, Precision precision, long seed) {
    List<String> names = List.of(channels.split(" "));
    return new ImageLayer(name, names, precision, WIDTH, HEIGHT, values(names.size(), seed));
  }

  private Path written(List<ImageLayer> layers, Map<String, String> metadata) throws IOException {
    Path file = folder.resolve("a.exr");
    Options options = new Options(Exposure.NONE, ToneCurve.SRGB, 8, metadata);
    ImageWriter.write(picture(), layers, file, options);
    return file;
  }

  @Test
  void layersAreReadAsTheyWereWritten() throws IOException {
    List<ImageLayer> layers =
        List.of(
            layer("depth", "Z", Precision.FLOAT, 2),
            layer("lights.key", "R G B", Precision.FLOAT, 3),
            layer("normal", "X Y Z", Precision.HALF, 4),
            layer("aLayerWithANameOfMoreThan31Characters", "A B", Precision.FLOAT, 5));
    LayeredImage read = LayeredImage.read(written(layers, Map.of("Scene", "größe")));
    assertThat(read.texts()).containsEntry("Scene", "größe");
    assertThat(read.layers()).hasSize(5);
    assertThat(read.layer("").orElseThrow().channels()).containsExactly("R", "G", "B");
    assertThat(read.layer("").orElseThrow().values()).isEqualTo(picture().rgb());
    for (ImageLayer layer : layers) {
      ImageLayer found = read.layer(layer.name()).orElseThrow();
      assertThat(found.precision()).isEqualTo(layer.precision());
      List<String> sorted = found.channels();
      for (int i = 0; i < found.values().length; i++) {
        int pixel = i / sorted.size();
        int channel = layer.channels().indexOf(sorted.get(i % sorted.size()));
        float expected = layer.value(pixel % WIDTH, pixel / WIDTH, channel);
        if (layer.precision() == Precision.HALF) {
          assertThat(found.values()[i]).isCloseTo(expected, withinPercentage(.05));
        } else {
          assertThat(found.values()[i]).isEqualTo(expected);
        }
      }
    }
    assertThat(LinearReader.read(folder.resolve("a.exr")).rgb()).isEqualTo(picture().rgb());
  }

  @Test
  void everyHalfIsKept() {
    for (int bits = 0; bits < 1 << 16; bits++) {
      float value = ExrChannel.ofHalf((short) bits);
      if (Float.isFinite(value)) {
        assertThat(ExrChannel.toHalf(value)).isEqualTo((short) bits);
      }
    }
  }

  /** Between two halves, the nearer one is chosen, and the even one in the middle. */
  @Test
  void numbersAreRoundedToTheNearestHalf() {
    for (int bits = 0; bits < 0x7bff; bits++) {
      float low = ExrChannel.ofHalf((short) bits);
      float high = ExrChannel.ofHalf((short) (bits + 1));
      float middle = (low + high) / 2;
      assertThat(ExrChannel.toHalf(middle)).isEqualTo((short) (bits + (bits & 1)));
      assertThat(ExrChannel.toHalf(Math.nextDown(middle))).isEqualTo((short) bits);
      assertThat(ExrChannel.toHalf(Math.nextUp(middle))).isEqualTo((short) (bits + 1));
      assertThat(ExrChannel.toHalf(-middle)).isEqualTo((short) (0x8000 | bits + (bits & 1)));
    }
    assertThat(ExrChannel.toHalf(1e30f)).isEqualTo((short) 0x7bff);
    assertThat(ExrChannel.toHalf(Float.NEGATIVE_INFINITY)).isEqualTo((short) 0xfbff);
    assertThat(ExrChannel.toHalf(Float.MIN_VALUE)).isZero();
  }

  @Test
  void valuesThatAreNotFiniteAreReplaced() throws IOException {
    float[] values = new float[WIDTH * HEIGHT];
    values[0] = Float.NaN;
    values[1] = Float.POSITIVE_INFINITY;
    for (Precision precision : Precision.values()) {
      ImageLayer layer = new ImageLayer("depth", List.of("Z"), precision, WIDTH, HEIGHT, values);
      float[] read =
          LayeredImage.read(written(List.of(layer), Map.of())).layer("depth").get().values();
      assertThat(read[0]).isZero();
      assertThat(read[1]).isEqualTo(precision == Precision.HALF ? 65504 : Float.MAX_VALUE);
    }
  }

  @Test
  void wrongLayersAreRejected() {
    ImageLayer depth = layer("depth", "Z", Precision.FLOAT, 2);
    assertThatThrownBy(() -> written(List.of(depth, depth), Map.of()))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("layers: expected different channels, found depth.Z twice");
    ImageLayer small = new ImageLayer("depth", List.of("Z"), Precision.FLOAT, 1, 2, new float[2]);
    assertThatThrownBy(() -> written(List.of(small), Map.of()))
        .hasMessage("layers: expected 37x35 pixels, found 1x2 in depth");
    assertThatThrownBy(
            () ->
                ImageWriter.write(
                    picture(), List.of(depth), folder.resolve("a.png"), Options.DEFAULT))
        .hasMessage("layers: expected an .exr file, found .png");
    assertThatThrownBy(
            () -> new ImageLayer("a\n", List.of("Z"), Precision.FLOAT, 1, 1, new float[1]))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(
            () -> new ImageLayer("a", List.of("Z", "Z"), Precision.FLOAT, 1, 1, new float[2]))
        .hasMessageContaining("different names");
    assertThatThrownBy(() -> new ImageLayer("a", List.of("Z"), Precision.FLOAT, 2, 1, new float[1]))
        .hasMessage("values: expected 2, found 1");
  }

  @Test
  void layersBecomePictures() {
    ImageLayer depth =
        new ImageLayer("depth", List.of("Z"), Precision.FLOAT, 1, 1, new float[] {3});
    assertThat(depth.toImage().pixel(0, 0)).isEqualTo(new Rgb(3, 3, 3));
    ImageLayer uv =
        new ImageLayer("uv", List.of("U", "V"), Precision.FLOAT, 1, 1, new float[] {3, 4});
    assertThat(uv.toImage().pixel(0, 0)).isEqualTo(new Rgb(3, 4, 0));
  }

  @Test
  void damagedFilesAreRefusedOrRead() throws IOException {
    Cryptomatte matte = Cryptomatte.of("CryptoObject", WIDTH, HEIGHT, i -> Map.of("a" + i % 3, 1f));
    byte[] bytes = Files.readAllBytes(written(matte.layers(), matte.metadata()));
    Random random = new Random(5);
    int read = 0;
    for (int run = 0; run < 3000; run++) {
      byte[] damaged = bytes.clone();
      int from = random.nextBoolean() ? 0 : random.nextInt(damaged.length - 600);
      for (int i = 0; i <= random.nextInt(3); i++) {
        damaged[from + random.nextInt(600)] = (byte) random.nextInt();
      }
      if (random.nextInt(10) == 0) {
        damaged = Arrays.copyOf(damaged, random.nextInt(damaged.length));
      }
      try {
        Cryptomatte.in(LayeredImage.of(damaged)).forEach(found -> found.mask("a1"));
        read++;
      } catch (ImageFormatException e) {
        assertThat(e.getMessage()).isNotBlank();
      }
    }
    assertThat(read).isBetween(1, 2999);
  }

  @Test
  void hashesAreThoseOfMurmur() {
    assertThat(Cryptomatte.hash("")).isZero();
    assertThat(Cryptomatte.hash("hello")).isEqualTo(0x248bfa47);
    assertThat(Cryptomatte.hash("hello, world")).isEqualTo(0x149bbb7f);
    assertThat(Cryptomatte.hash("The quick brown fox jumps over the lazy dog"))
        .isEqualTo(0x2e4ff723);
    for (int i = 0; i < 100_000; i++) {
      float id = Float.intBitsToFloat(Cryptomatte.id("item " + i));
      assertThat(Float.isFinite(id) && Math.abs(id) >= Float.MIN_NORMAL).isTrue();
    }
  }

  @Test
  void mattesKeepTheLargestShares() throws IOException {
    Map<String, Float> shares =
        Map.of("a", .3f, "b", .2f, "c", .15f, "d", .1f, "e", .09f, "größe \"g\"", .06f, "h", .05f);
    Cryptomatte matte =
        Cryptomatte.of("CryptoObject", WIDTH, HEIGHT, i -> i == 40 ? shares : Map.of("b", 1f));
    LayeredImage file = LayeredImage.read(written(matte.layers(), matte.metadata()));
    List<Cryptomatte> read = Cryptomatte.in(file);
    assertThat(read).hasSize(1);
    assertThat(read.get(0).ids()).isEqualTo(matte.ids()).containsOnlyKeys(shares.keySet());
    shares.forEach(
        (name, share) ->
            assertThat(read.get(0).mask(name)[40]).isEqualTo(name.equals("h") ? 0 : share));
    assertThat(read.get(0).mask("b")[41]).isEqualTo(1);
    assertThat(read.get(0).mask("unknown")).containsOnly(0);
  }

  @Test
  void wrongManifestsAreRefused() throws IOException {
    for (String manifest :
        List.of("", "[]", "{\"a\":{}}", "{\"a\":\"xyz\"}", "{\"a\":", "[".repeat(99_999))) {
      Map<String, String> metadata =
          Map.of("cryptomatte/1234567/name", "X", "cryptomatte/1234567/manifest", manifest);
      LayeredImage file = LayeredImage.read(written(List.of(), metadata));
      assertThatThrownBy(() -> Cryptomatte.in(file))
          .isInstanceOf(ImageFormatException.class)
          .hasMessageContaining("manifest");
    }
  }

  @Test
  void bytesOfPngAreThoseOfTheFile() throws IOException {
    Path file = folder.resolve("a.png");
    ImageWriter.write(picture(), file);
    assertThat(picture().toPng()).isEqualTo(Files.readAllBytes(file));
  }

  @Test
  void otherFilesAreNoLayeredPictures() {
    assertThatThrownBy(() -> LayeredImage.of("hello, file".getBytes(StandardCharsets.UTF_8)))
        .isInstanceOf(ImageFormatException.class)
        .hasMessageContaining("expected an OpenEXR file, found another kind of file");
    assertThatThrownBy(() -> LayeredImage.of(picture().toPng()))
        .hasMessageContaining("expected an OpenEXR file, found a PNG picture");
  }

  /** Channels are sorted by bytes, where \uff5e is before \ud83c\udf33, unlike in Java's order. */
  @Test
  void namesBeyondAsciiAreUtf8() throws IOException {
    List<String> names = List.of("größe", "高さ", "\uff5e", "\ud83c\udf33", "é".repeat(16));
    List<ImageLayer> layers =
        names.stream().map(name -> layer(name, "Ä Ω", Precision.FLOAT, 6)).toList();
    Path file = written(layers, Map.of());
    byte[] bytes = Files.readAllBytes(file);
    assertThat(bytes[5]).as("long names, by their bytes").isEqualTo((byte) 4);
    String text = new String(bytes, StandardCharsets.ISO_8859_1);
    int last = 0;
    for (String channel : List.of("größe.Ä", "高さ.Ω", "\uff5e.Ä", "\ud83c\udf33.Ω")) {
      byte[] utf8Bytes = channel.getBytes(StandardCharsets.UTF_8);
      String utf8 = new String(utf8Bytes, StandardCharsets.ISO_8859_1);
      assertThat(text.indexOf(utf8 + "\0")).as(channel).isGreaterThan(last);
      last = text.indexOf(utf8 + "\0");
    }
    LayeredImage read = LayeredImage.read(file);
    for (ImageLayer layer : layers) {
      ImageLayer found = read.layer(layer.name()).orElseThrow();
      assertThat(found.channels()).containsExactly("Ä", "Ω");
      assertThat(found.values()).isEqualTo(layer.values());
    }
  }
}
