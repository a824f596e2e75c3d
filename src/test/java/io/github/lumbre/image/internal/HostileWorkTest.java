package io.github.lumbre.image.internal;

import static io.github.lumbre.image.ImageFormatException.Kind.TOO_LARGE;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.format.jpeg.ProgressiveJpeg;
import io.github.lumbre.image.format.png.PngFixture;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests small files that would keep a decoder busy for a long time; work is counted in scans, not
 * in time.
 */
class HostileWorkTest {
  private static void assertRefused(byte[] file, String message) {
    assertThatThrownBy(() -> ImageReader.decode(file))
        .isInstanceOfSatisfying(
            ImageFormatException.class, e -> assertThat(e.kind()).isEqualTo(TOO_LARGE))
        .hasMessage(message);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 10, 99, 100})
  void asManyScansAsScriptsMayHaveAreDecoded(int scans) throws IOException {
    Pixels pixels = ImageReader.decode(ProgressiveJpeg.gray(2, scans));
    assertThat(pixels.width()).isEqualTo(16);
    assertThat(pixels.raw(15, 15, 1)).isEqualTo(128);
  }

  @ParameterizedTest
  @ValueSource(ints = {101, 400, 896})
  void moreScansAreRefused(int scans) {
    assertRefused(
        ProgressiveJpeg.gray(2, scans),
        "JPEG has "
            + scans
            + " scans, expected at most 100; save it again as a baseline JPEG or as a PNG");
  }

  /** A decoder skips these bytes between scans, so the counter must not stop at them. */
  @Test
  void scansAreNotHiddenByWhatLiesBetweenThem() {
    byte[] file = ProgressiveJpeg.gray(2, 101);
    byte[][] disguises = {
      {(byte) 0xff, (byte) 0xff},
      {(byte) 0xff, (byte) 0xd0},
      {(byte) 0xff, (byte) 0xfe, 0, 4, (byte) 0xff, (byte) 0xd9},
      {(byte) 0xff, 0},
      {17}
    };
    for (byte[] disguise : disguises) {
      assertRefused(
          beforeEachScan(file, disguise),
          "JPEG has 101 scans, expected at most 100; save it again as a baseline JPEG or as a PNG");
    }
  }

  private static byte[] beforeEachScan(byte[] file, byte[] inserted) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    int scans = 0;
    for (int i = 0; i < file.length; i++) {
      boolean isScan = file[i] == (byte) 0xff && file[i + 1] == (byte) 0xda;
      // The first scan is found earlier; other tests check the header.
      if (isScan && scans++ > 0) {
        out.writeBytes(inserted);
      }
      out.write(file[i]);
    }
    return out.toByteArray();
  }

  /** Bytes in a comment that look like a scan are not counted. */
  @Test
  void commentsAreNotCounted() throws IOException {
    byte[] comment = {(byte) 0xff, (byte) 0xfe, 0, 6, (byte) 0xff, (byte) 0xda, 0, 8};
    byte[] file = beforeEachScan(ProgressiveJpeg.gray(2, 60), comment);
    assertThat(ImageReader.decode(file).raw(0, 0, 0)).isEqualTo(128);
  }

  @Test
  void chunksOfImageDataMayBeShortOrEmpty() throws IOException {
    PngFixture fixture = new PngFixture().header(1, 1, 8, PngFixture.RGB, false);
    byte[] data = PngFixture.deflated(new byte[4]);
    for (int i = 0; i < 1000; i++) {
      fixture.chunk("IDAT", i < data.length ? new byte[] {data[i]} : new byte[0]);
    }
    byte[] file = fixture.end();
    assertThat(ImageReader.decode(file).raw(0, 0, 0)).isZero();
  }
}
