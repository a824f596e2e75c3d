package io.github.lumbre.image.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.image.format.jpeg.JpegFixture;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the reading of pictures as linear RGB. */
class LinearReaderTest {
  @TempDir private Path directory;

  private byte[] written(Image image, String name) throws IOException {
    return ImageFixture.written(image, directory.resolve(name), ImageWriter.Options.DEFAULT);
  }

  @ParameterizedTest
  @CsvSource({"1, 1", "5, 3", "17, 33", "300, 2"})
  void floatFilesAreReadBackToTheBit(int width, int height) throws IOException {
    Image image = ImageFixture.random(width, height, false);
    for (String name : new String[] {"a.exr", "a.pfm"}) {
      Image read = LinearReader.decode(written(image, name));
      assertThat(read.width()).isEqualTo(width);
      assertThat(read.hasAlpha()).isFalse();
      assertThat(read.rgb()).isEqualTo(image.rgb());
    }
  }

  @Test
  void compressedBlocksAreReadBack() throws IOException {
    Image even = new Image(64, 40, new float[3 * 64 * 40], new float[0]);
    Arrays.fill(even.rgb(), .75f);
    byte[] file = written(even, "a.exr");
    assertThat(file).hasSizeLessThan(64 * 40);
    assertThat(LinearReader.decode(file).rgb()).isEqualTo(even.rgb());
  }

  @Test
  void colorsAndAlphaOfOpenExrAreApartAgain() throws IOException {
    Image image = ImageFixture.random(9, 20, true);
    Image read = LinearReader.decode(written(image, "a.exr"));
    for (int i = 0; i < image.rgb().length; i++) {
      int pixel = i / 3;
      assertThat(read.alpha(pixel % 9, pixel / 9)).isEqualTo(image.alpha(pixel % 9, pixel / 9));
      assertThat(read.rgb()[i]).isCloseTo(image.rgb()[i], within(1e-6f));
    }
  }

  @Test
  void metadataOfOpenExrAreNoHindrance() throws IOException {
    Map<String, String> metadata =
        Map.of("Scene", "a", "A keyword that is longer than thirty-one", "b");
    ImageWriter.Options options =
        new ImageWriter.Options(Exposure.NONE, ToneCurve.SRGB, 8, metadata);
    Image image = ImageFixture.random(3, 3, false);
    byte[] file = ImageFixture.written(image, directory.resolve("a.exr"), options);
    assertThat(LinearReader.decode(file).rgb()).isEqualTo(image.rgb());
  }

  @Test
  void pngIsDecodedToLinearLight() throws IOException {
    Image image = ImageFixture.grays(0, .001, .2140411, .7, 1, 3);
    float[] read = LinearReader.decode(written(image, "a.png")).rgb();
    assertThat(read[0]).isZero();
    // Half of an 8-bit step where the curve is steepest for these values.
    assertThat(read[6]).isCloseTo(.214f, within(.003f));
    assertThat(read[12]).isEqualTo(1);
    assertThat(read[15]).isEqualTo(1);
  }

  @Test
  void floatMapsOfOtherProgramsAreRead() throws IOException {
    ByteBuffer file = ByteBuffer.allocate(12 + 8);
    file.put("Pf 1 2\r\n2.5\n".getBytes(StandardCharsets.US_ASCII)).putFloat(3).putFloat(7);
    // Big-endian, gray, with the bottom row first.
    assertThat(LinearReader.decode(file.array()).rgb()).containsExactly(7, 7, 7, 3, 3, 3);
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "P", "PF\n", "PF\nx 1\n-1\n", "PF\n0 1\n-1\n", "PF\n9 9\n-1\nab"})
  void brokenFilesAreRefused(String text) {
    assertThatThrownBy(() -> LinearReader.decode(text.getBytes(StandardCharsets.US_ASCII)))
        .isInstanceOf(ImageFormatException.class);
  }

  @ParameterizedTest
  @ValueSource(strings = {"a.exr", "a.pfm"})
  void everyTruncationIsRefused(String name) throws IOException {
    byte[] file = written(ImageFixture.random(7, 18, false), name);
    for (int length = 0; length < file.length; length++) {
      byte[] part = Arrays.copyOf(file, length);
      assertThatThrownBy(() -> LinearReader.decode(part)).isInstanceOf(ImageFormatException.class);
    }
  }

  @Test
  void damagedOpenExrGivesAPictureOrARefusal() throws IOException {
    byte[] file = written(ImageFixture.random(7, 18, true), "a.exr");
    SplittableRandom random = new SplittableRandom(1);
    for (int i = 0; i < 20_000; i++) {
      byte[] damaged = file.clone();
      damaged[random.nextInt(i % 2 == 0 ? 400 : file.length)] = (byte) random.nextInt(256);
      try {
        LinearReader.decode(damaged);
      } catch (ImageFormatException e) {
        assertThat(e).hasMessageNotContaining("null");
      }
    }
  }

  @Test
  void brokenFloatMapsAreRefusedForTheReason() {
    assertFloatMapRefused("PF\n0 1\n-1\n", "the picture has no pixels");
    assertFloatMapRefused("PF\n1 0\n-1\n", "the picture has no pixels");
    assertFloatMapRefused("PF\n-1 1\n-1\n", "its header is damaged");
    assertFloatMapRefused("PF\n1 -1\n-1\n", "its header is damaged");
    assertFloatMapRefused("PF\n1 1\n0\n", "its header is damaged");
    assertFloatMapRefused("PF\n1 1\nInfinity\n", "its header is damaged");
    assertFloatMapRefused("PF\n9 7\n-1\nab", "expected 756 bytes of pixels, found 2");
    assertFloatMapRefused("Pf\n9 7\n-1\nab", "expected 252 bytes of pixels, found 2");
    assertFloatMapRefused("PF\n9 7\n-1", "expected 756 bytes of pixels, found 0");
    assertFloatMapRefused("PF\n" + "0".repeat(90) + "1 1\n-1\n123412341234", "no pixels");
    assertFloatMapRefused("PFM\n1 1\n-1\n123412341234", "found none of them");
    assertFloatMapRefused("PF", "found none of them");
  }

  private static void assertFloatMapRefused(String text, String message) {
    assertThatThrownBy(() -> LinearReader.decode(text.getBytes(StandardCharsets.US_ASCII)))
        .isInstanceOf(ImageFormatException.class)
        .hasMessageContaining(message);
  }

  /** Programs disagree about the meaning of a scale other than 1. */
  @Test
  void scaleOfAFloatMapSaysTheOrderOfItsBytesAlone() throws IOException {
    for (String scale : new String[] {"-1", "-2.5", "1", "1e-3"}) {
      byte[] header = ("PF  1\t1\n" + scale + " ").getBytes(StandardCharsets.US_ASCII);
      ByteBuffer file = ByteBuffer.allocate(header.length + 12).put(header);
      file.order(scale.startsWith("-") ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
      file.putFloat(3).putFloat(5).putFloat(7);
      assertThat(LinearReader.decode(file.array()).rgb()).containsExactly(3, 5, 7);
    }
  }

  @Test
  void filesAreReadByTheirContentAndNotTheirName() throws IOException {
    Image image = ImageFixture.random(4, 3, false);
    Path file = directory.resolve("a.png");
    Files.write(file, written(image, "b.exr"));
    assertThat(LinearReader.read(file).rgb()).isEqualTo(image.rgb());
  }

  @Test
  void jpegIsDecodedToLinearLight() throws IOException {
    byte[] file =
        new JpegFixture().header(1, 1, "RGB").scan(1, 1, "RGB", (c, x, y) -> 100 + 50 * c).end();
    Image read = LinearReader.decode(file);
    assertThat(read.width()).isEqualTo(8);
    for (int c = 0; c < 3; c++) {
      assertThat(read.rgb()[3 * 37 + c]).isEqualTo((float) Srgb.fromByte(100 + 50 * c));
    }
  }
}
