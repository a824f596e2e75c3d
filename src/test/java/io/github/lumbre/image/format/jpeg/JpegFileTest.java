package io.github.lumbre.image.format.jpeg;

import static io.github.lumbre.testing.Pictures.assertSame;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.format.jpeg.JpegFixture.Values;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.SplittableRandom;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.stream.ImageOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the color space of JPEG files, given by their markers and component names. */
class JpegFileTest {
  private static final int WIDTH = 3;
  private static final int HEIGHT = 2;
  private static final String NUMBERS = "\1\2\3";

  /** Values that differ in each component and block. */
  private static final Values VALUES = (c, x, y) -> 20 + 31 * c + 40 * x + 17 * y;

  private static byte[] finished(JpegFixture start, String ids) {
    return start.header(WIDTH, HEIGHT, ids).scan(WIDTH, HEIGHT, ids, VALUES).end();
  }

  /** A color of the picture, computed from the values of its components. */
  private interface Meaning {
    double channel(int channel, double[] values);
  }

  private static void assertMeans(byte[] file, int components, Meaning meaning) throws IOException {
    Pixels pixels = ImageReader.decode(file);
    assertThat(pixels.width()).isEqualTo(8 * WIDTH);
    assertThat(pixels.height()).isEqualTo(8 * HEIGHT);
    double[] values = new double[components];
    for (int y = 0; y < pixels.height(); y++) {
      for (int x = 0; x < pixels.width(); x++) {
        for (int i = 0; i < components; i++) {
          values[i] = VALUES.at(i, x / 8, y / 8);
        }
        for (int channel = 0; channel < 3; channel++) {
          double expected = Math.max(0, Math.min(255, meaning.channel(channel, values)));
          assertThat((double) pixels.raw(x, y, channel))
              .as("%d,%d channel %d", x, y, channel)
              .isCloseTo(expected, within(1.01));
        }
      }
    }
  }

  /** ITU-R BT.601, as in JFIF. */
  private static double yccToRgb(int channel, double[] v) {
    double cb = v[1] - 128;
    double cr = v[2] - 128;
    return switch (channel) {
      case 0 -> v[0] + 1.402 * cr;
      case 1 -> v[0] - .344136 * cb - .714136 * cr;
      default -> v[0] + 1.772 * cb;
    };
  }

  @Test
  void threeNumberedComponentsAreLumaAndChroma() throws IOException {
    assertMeans(finished(new JpegFixture(), NUMBERS), 3, JpegFileTest::yccToRgb);
    assertMeans(finished(new JpegFixture().jfif(), NUMBERS), 3, JpegFileTest::yccToRgb);
    assertMeans(finished(new JpegFixture().adobe(1), NUMBERS), 3, JpegFileTest::yccToRgb);
  }

  @Test
  void componentsNamedRgbAreColors() throws IOException {
    assertMeans(finished(new JpegFixture(), "RGB"), 3, (channel, v) -> v[channel]);
    for (String other : new String[] {"XGB", "RXB", "RGX"}) {
      assertMeans(finished(new JpegFixture(), other), 3, JpegFileTest::yccToRgb);
    }
  }

  @Test
  void markersCountForMoreThanNames() throws IOException {
    assertMeans(finished(new JpegFixture().jfif(), "RGB"), 3, JpegFileTest::yccToRgb);
    assertMeans(finished(new JpegFixture().adobe(1), "RGB"), 3, JpegFileTest::yccToRgb);
    assertMeans(finished(new JpegFixture().adobe(0), NUMBERS), 3, (channel, v) -> v[channel]);
  }

  /** Segments that only resemble the markers, with another name or too short, have no effect. */
  @Test
  void otherApplicationSegmentsMeanNothing() throws IOException {
    for (String text : new String[] {"JFXX\0\20", "JFIF", "", "J", "Adobe\0d\0\0\0\0", "Adobf"}) {
      byte[] content = text.getBytes(StandardCharsets.US_ASCII);
      for (int marker : new int[] {0xe0, 0xe1, 0xee}) {
        byte[] file = finished(new JpegFixture().segment(marker, content), "RGB");
        assertMeans(file, 3, (channel, v) -> v[channel]);
      }
    }
    byte[] jfif = "JFIF\0\1\1\0\0\1\0\1\0\0".getBytes(StandardCharsets.US_ASCII);
    byte[] elsewhere = finished(new JpegFixture().segment(0xe3, jfif), "RGB");
    assertMeans(elsewhere, 3, (channel, v) -> v[channel]);
    byte[] adobe = "Adobe\0d\0\0\0\0\1".getBytes(StandardCharsets.US_ASCII);
    byte[] comment = finished(new JpegFixture().segment(0xfe, adobe), "RGB");
    assertMeans(comment, 3, (channel, v) -> v[channel]);
  }

  /** By Adobe's convention, 255 means no ink. */
  @Test
  void fourComponentsOfAdobeAreInvertedInks() throws IOException {
    assertMeans(
        finished(new JpegFixture().adobe(0), "CMYK"), 4, (channel, v) -> v[channel] * v[3] / 255);
  }

  @Test
  void fourComponentsOfNobodyAreInks() throws IOException {
    assertMeans(
        finished(new JpegFixture(), "CMYK"),
        4,
        (channel, v) -> (255 - v[channel]) * (255 - v[3]) / 255);
  }

  @Test
  void lumaAndChromaOfInksAreTurnedIntoInks() throws IOException {
    assertMeans(
        finished(new JpegFixture().adobe(2), "\1\2\3\4"),
        4,
        (channel, v) -> {
          double ink = Math.max(0, Math.min(255, 255 - yccToRgb(channel, v)));
          return ink * v[3] / 255;
        });
  }

  @Test
  void grayIsOneComponent() throws IOException {
    assertMeans(finished(new JpegFixture(), "\1"), 1, (channel, v) -> v[0]);
  }

  @Test
  void commentsAndFillBytesAreSkipped() throws IOException {
    JpegFixture start =
        new JpegFixture()
            .segment(0xfe, "a comment".getBytes(StandardCharsets.US_ASCII))
            .segment(0xfe, new byte[0])
            .bytes(0xff, 0xff)
            .segment(0xef, new byte[300])
            .bytes(0xff);
    byte[] file = finished(start, "RGB");
    assertMeans(file, 3, (channel, v) -> v[channel]);
    byte[] plain = finished(new JpegFixture(), "RGB");
    assertThat(JpegFile.read(file).content()).isEqualTo(JpegFile.read(plain).content());
    assertThat(JpegFile.read(plain).content()).isEqualTo(plain);
  }

  private static void assertMalformed(byte[] file, String message) {
    assertThatThrownBy(() -> ImageReader.decode(file))
        .isInstanceOfSatisfying(
            ImageFormatException.class,
            e -> assertThat(e.kind()).isEqualTo(ImageFormatException.Kind.MALFORMED))
        .hasMessageStartingWith(message);
  }

  @Test
  void damagedSegmentsAreNamed() {
    byte[] scan = new JpegFixture().scan(1, 1, NUMBERS, VALUES).end();
    assertMalformed(scan, "JPEG has no header");
    assertMalformed(
        new JpegFixture().bytes(0xff, 0xfe, 0, 1, 0).end(),
        "JPEG is damaged: a segment with an invalid length at byte 2");
    assertMalformed(
        new JpegFixture().segment(0xfe, new byte[3]).bytes(0, 0, 0, 0).end(),
        "JPEG is damaged: no marker at byte 9");
    assertMalformed(
        new JpegFixture().bytes(0xff, 0xfe, 0, 6, 1, 2, 3).unfinished(), "JPEG is truncated");
    assertMalformed(new JpegFixture().bytes(0xff, 0xff, 0xff).unfinished(), "JPEG is truncated");
    assertMalformed(new JpegFixture().unfinished(), "expected a PNG, JPEG");
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 5, 6, 14})
  void framesMustHoldTheirComponents(int length) {
    byte[] whole = {8, 0, 8, 0, 8, 3, 1, 17, 0, 2, 17, 0, 3, 17, 0};
    byte[] frame = Arrays.copyOf(whole, length);
    assertMalformed(
        new JpegFixture().segment(0xc0, frame).bytes(0xff, 0xd9).end(),
        "JPEG has a header that is too short");
  }

  @Test
  void channelsHaveEightBits() {
    byte[] frame = {12, 0, 8, 0, 8, 1, 1, 17, 0};
    assertMalformed(
        new JpegFixture().segment(0xc1, frame).end(), "JPEG has 12 bits a channel, expected 8");
  }

  private static JpegFixture sound() {
    return new JpegFixture().header(3, 2, NUMBERS).scan(3, 2, NUMBERS, VALUES);
  }

  @Test
  void theEndMarkerMayBeMissing() throws ImageFormatException {
    Pixels whole = ImageReader.decode(sound().end());
    byte[] data = sound().unfinished();
    assertSame(ImageReader.decode(data), whole);
    assertSame(ImageReader.decode(sound().bytes(0xff).unfinished()), whole);
    for (int length = 0; length < data.length; length++) {
      byte[] cut = Arrays.copyOf(data, length);
      assertThatThrownBy(() -> ImageReader.decode(cut)).isInstanceOf(ImageFormatException.class);
    }
  }

  /** A scan that is missing would leave a color or a detail out. */
  @Test
  void aMissingScanIsNotPassedOver() {
    JpegFixture one = new JpegFixture().header(1, 1, NUMBERS).scan(1, 1, "\1", VALUES);
    assertMalformed(one.unfinished(), "JPEG is truncated");
    assertMalformed(one.bytes(0x12, 0xd9, 0xff, 0).unfinished(), "JPEG is truncated");
  }

  @Test
  void everyScanOfAProgressivePictureIsNeeded() throws IOException {
    byte[] file = progressive();
    Pixels whole = ImageReader.decode(file);
    int accepted = 0;
    for (int length = 2; length < file.length; length++) {
      byte[] cut = Arrays.copyOf(file, length);
      try {
        assertSame(ImageReader.decode(cut), whole);
        accepted++;
      } catch (ImageFormatException e) {
        assertThat(length).isLessThan(file.length - 1);
      }
    }
    assertThat(accepted).isEqualTo(2);
  }

  /** Returns a small progressive picture with several scans. */
  private static byte[] progressive() throws IOException {
    BufferedImage picture = new BufferedImage(24, 16, BufferedImage.TYPE_INT_RGB);
    SplittableRandom random = new SplittableRandom(5);
    for (int i = 0; i < 24 * 16; i++) {
      picture.setRGB(i % 24, i / 24, random.nextInt());
    }
    javax.imageio.ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
    ImageWriteParam param = writer.getDefaultWriteParam();
    param.setProgressiveMode(ImageWriteParam.MODE_DEFAULT);
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (ImageOutputStream stream = ImageIO.createImageOutputStream(out)) {
      writer.setOutput(stream);
      writer.write(null, new IIOImage(picture, null, null), param);
    } finally {
      writer.dispose();
    }
    return out.toByteArray();
  }
}
