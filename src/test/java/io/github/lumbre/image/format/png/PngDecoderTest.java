package io.github.lumbre.image.format.png;

import static io.github.lumbre.testing.Refusals.assertCancelled;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.internal.EncodedFormat;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Random;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** PNG files with filters, of any bytes, have the values that Java's own decoder finds. */
class PngDecoderTest {
  private static final int WIDTH = 61;
  private static final int HEIGHT = 47;

  private static int rowBytes(int columns, int depth, int colorType) {
    return (columns * depth * PngFixture.channels(colorType) + 7) / 8;
  }

  /** Returns a picture whose rows have random filters and bytes, in several chunks. */
  private static byte[] file(Random random, int colorType, int depth, boolean interlaced) {
    ByteArrayOutputStream raw = new ByteArrayOutputStream();
    for (int pass = 0; pass < (interlaced ? 7 : 1); pass++) {
      int[] steps = interlaced ? PngFixture.ADAM7[pass] : new int[] {0, 0, 1, 1};
      int columns = (WIDTH - steps[0] + steps[2] - 1) / steps[2];
      for (int y = steps[1]; y < HEIGHT; y += steps[3]) {
        byte[] row = new byte[1 + rowBytes(columns, depth, colorType)];
        random.nextBytes(row);
        row[0] = (byte) random.nextInt(5);
        raw.writeBytes(row);
      }
    }
    PngFixture file = new PngFixture().header(WIDTH, HEIGHT, depth, colorType, interlaced);
    if (colorType == PngFixture.PALETTE) {
      byte[] colors = new byte[3 << depth];
      random.nextBytes(colors);
      file.chunk("PLTE", colors);
    }
    byte[] data = PngFixture.deflated(raw.toByteArray());
    for (int at = 0; at < data.length; ) {
      int length = Math.min(data.length - at, random.nextInt(900));
      byte[] piece = new byte[length];
      System.arraycopy(data, at, piece, 0, length);
      file.chunk("IDAT", piece);
      at += length;
    }
    return file.end();
  }

  @ParameterizedTest(name = "type {0}, {1} bits")
  @CsvSource({
    "0, 1", "0, 2", "0, 4", "0, 8", "0, 16", "2, 8", "2, 16", "3, 1", "3, 2", "3, 4", "3, 8",
    "4, 8", "4, 16", "6, 8", "6, 16"
  })
  void filtersAreUndone(int colorType, int depth) throws IOException {
    Random random = new Random(31 * colorType + depth);
    for (int i = 0; i < 20; i++) {
      byte[] file = file(random, colorType, depth, i % 2 == 1);
      Pixels found = ImageReader.decode(file);
      var expected = ImageIO.read(new ByteArrayInputStream(file));
      Raster raster = expected.getRaster();
      int channels = found.hasAlpha() ? 4 : 3;
      for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
          for (int c = 0; c < channels; c++) {
            int band = Math.min(c == 3 ? raster.getNumBands() - 1 : c, raster.getNumBands() - 1);
            band = colorType == PngFixture.GRAY_ALPHA && c < 3 ? 0 : band;
            int shift = 8 * (2 - c);
            int value =
                colorType == PngFixture.PALETTE
                    ? expected.getRGB(x, y) >> shift & 0xff
                    : raster.getSample(x, y, band) * (depth < 8 ? 255 / ((1 << depth) - 1) : 1);
            int actual = c == 3 ? found.alpha(x, y) : found.raw(x, y, c);
            assertThat(actual).as(x + "," + y + "," + c).isEqualTo(value);
          }
        }
      }
    }
  }

  @ParameterizedTest
  @CsvSource({"0, 1, 1", "2, 8, 3", "2, 16, 6", "3, 4, 3", "4, 16, 4", "6, 8, 4", "6, 16, 8"})
  void memoryIsCountedBeforeDecoding(int colorType, int depth, int bytes)
      throws ImageFormatException {
    byte[] file = file(new Random(1), colorType, depth, false);
    assertThat(EncodedFormat.open(file, Limits.NONE).bytesPerPixel()).isEqualTo(bytes);
  }

  @Test
  void unknownFiltersAreDamage() {
    byte[] file =
        new PngFixture()
            .header(2, 1, 8, PngFixture.GRAY, false)
            .chunk("IDAT", PngFixture.deflated(new byte[] {(byte) 200, 1, 2}))
            .end();
    assertThatThrownBy(() -> ImageReader.decode(file))
        .isInstanceOf(ImageFormatException.class)
        .hasMessage("PNG is damaged: the unknown filter 200");
  }

  @Test
  void decodingEndsWithAnInterrupt() {
    byte[] file = file(new Random(1), PngFixture.RGB, 8, false);
    assertCancelled(() -> ImageReader.decode(file));
  }
}
