package io.github.lumbre.image.format.jpeg;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.image.internal.ImageFixture;
import io.github.lumbre.image.internal.Srgb;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests written JPEG files. */
class JpegWriterTest {
  @TempDir private Path directory;

  private byte[] written(Image image, int quality) throws IOException {
    Path file = directory.resolve("a.jpg");
    Map<String, String> metadata = Map.of("Scene", "käse \u4e00");
    ImageWriter.write(
        image, file, new ImageWriter.Options(Exposure.NONE, ToneCurve.SRGB, 16, quality, metadata));
    return Files.readAllBytes(file);
  }

  /**
   * Returns alternating red and blue columns; with halved color resolution, both would be purple.
   */
  private static Image stripes() {
    Image image = Image.black(32, 16);
    for (int i = 0; i < 32 * 16; i++) {
      image.rgb()[3 * i + i % 2 * 2] = .5f;
    }
    return image;
  }

  @Test
  void colorsHaveFullResolution() throws IOException {
    Pixels read = ImageReader.decode(written(stripes(), 100));
    int bright = (int) Math.round(255 * Srgb.encode(.5));
    for (int x = 0; x < 32; x++) {
      assertThat(read.raw(x, 5, x % 2 * 2)).isBetween(bright - 6, bright + 6);
      assertThat(read.raw(x, 5, 2 - x % 2 * 2)).isLessThan(6);
    }
  }

  @Test
  void exposureAndToneCurveAreThoseOfPng() throws IOException {
    Image image = Image.black(16, 16);
    Arrays.fill(image.rgb(), .2f);
    var options = new ImageWriter.Options(Exposure.of(1), ToneCurve.REINHARD, 8, 100, Map.of());
    ImageWriter.write(image, directory.resolve("a.jpg"), options);
    ImageWriter.write(image, directory.resolve("a.png"), options);
    int jpeg = ImageReader.decode(Files.readAllBytes(directory.resolve("a.jpg"))).raw(3, 3, 1);
    int png = ImageReader.decode(Files.readAllBytes(directory.resolve("a.png"))).raw(3, 3, 1);
    assertThat(jpeg).isBetween(png - 1, png + 1);
  }

  @Test
  void pixelsStandOverBlack() throws IOException {
    float[] rgb = new float[3 * 256];
    float[] alpha = new float[256];
    Arrays.fill(rgb, 1);
    Arrays.fill(alpha, .25f);
    Pixels read = ImageReader.decode(written(new Image(16, 16, rgb, alpha), 100));
    int expected = (int) Math.round(255 * Srgb.encode(.25));
    assertThat(read.raw(8, 8, 0)).isBetween(expected - 2, expected + 2);
  }

  @Test
  void qualityDecidesTheSize() throws IOException {
    Image noise = ImageFixture.random(64, 64, false);
    assertThat(written(noise, 10).length).isLessThan(written(noise, 90).length);
    assertThat(written(noise, 90).length).isLessThan(written(noise, 100).length);
    assertThatThrownBy(() -> written(noise, 0)).hasMessageContaining("1 to 100, found 0");
    assertThatThrownBy(() -> written(noise, 101)).hasMessageContaining("1 to 100, found 101");
  }

  @Test
  void metadataIsAComment() throws IOException {
    String file = new String(written(stripes(), 90), StandardCharsets.UTF_8);
    assertThat(file).contains("Scene: käse \u4e00");
  }
}
