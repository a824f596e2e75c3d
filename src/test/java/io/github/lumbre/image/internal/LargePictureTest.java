package io.github.lumbre.image.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.format.png.PngFixture;
import io.github.lumbre.testing.Effort;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The largest allowed picture takes little more memory than its bytes. */
@Tag(Effort.EXHAUSTIVE)
class LargePictureTest {
  private static final int SIDE = 16_384;
  private static final long PIXELS = (long) SIDE * SIDE;

  @Test
  void keepsAtMostFourBytesAPixel() throws IOException, ImageFormatException {
    byte[] file = file();
    long before = usedMemory();
    Pixels pixels = ImageReader.decode(file);
    assertThat(usedMemory() - before).isBetween(PIXELS, 4 * PIXELS + (16 << 20));
    for (int i = 0; i < 100_000; i++) {
      int x = (int) (i * 7919L % SIDE);
      int y = (int) (i * 104_729L % SIDE);
      assertThat(pixels.raw(x, y, i % 3)).isEqualTo(value(x, y, i % 3) & 255);
    }
    assertThat(pixels.raw(SIDE - 1, SIDE - 1, 2)).isEqualTo(value(SIDE - 1, SIDE - 1, 2) & 255);
  }

  private static byte value(int x, int y, int channel) {
    return (byte) ((x >> 4) + 3 * (y >> 4) + 50 * channel);
  }

  private static byte[] file() throws IOException {
    ByteArrayOutputStream deflated = new ByteArrayOutputStream();
    Deflater quick = new Deflater(Deflater.BEST_SPEED);
    try (DeflaterOutputStream rows = new DeflaterOutputStream(deflated, quick)) {
      byte[] row = new byte[1 + 3 * SIDE];
      for (int y = 0; y < SIDE; y++) {
        for (int i = 0; i < 3 * SIDE; i++) {
          row[1 + i] = value(i / 3, y, i % 3);
        }
        rows.write(row);
      }
    } finally {
      quick.end();
    }
    return new PngFixture()
        .header(SIDE, SIDE, 8, PngFixture.RGB, false)
        .chunk("IDAT", deflated.toByteArray())
        .end();
  }

  private static long usedMemory() {
    System.gc();
    return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
  }
}
