package io.github.lumbre.image.format.exr;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.LayeredImage;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.image.internal.LinearReader;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Pictures of OpenEXR files are those of their display windows. */
class ExrWindowTest {
  private static final int WIDTH = 11;
  private static final int HEIGHT = 20;

  private static double value(int x, int y) {
    return 1 + x + 100 * y;
  }

  /** Windows of data that extend beyond, lie inside, beside and far from those of display. */
  @ParameterizedTest
  @CsvSource({
    "-3, -4, 0, 0, 5, 9",
    "2, 3, 0, 0, 15, 29",
    "5, -7, 0, -2, 8, 40",
    "0, 0, -100000, -70000, -99990, -69990",
    "2000000000, 0, -2147483648, 0, -2147483640, 3",
    "7, 7, 7, 7, 17, 26",
  })
  void pixelsAreThoseOfTheDisplayWindow(int left, int top, int x0, int y0, int x1, int y1)
      throws ImageFormatException {
    for (int compression : new int[] {0, 1, 3}) {
      for (int tiles : new int[] {0, 4}) {
        ExrBuilder file =
            new ExrBuilder(WIDTH, HEIGHT, compression)
                .rgb("", ExrWindowTest::value)
                .channel("A", 1, (x, y) -> .5)
                .channel("far.Z", 2, ExrWindowTest::value)
                .windows(left, top, x0, y0, x1, y1);
        byte[] bytes = (tiles > 0 ? file.tiles(tiles, tiles, 0) : file).file();
        Image light = ImageFormat.read(bytes, ImageReader.MAX_PIXELS).light();
        LayeredImage layers = LayeredImage.of(bytes);
        assertThat(light.width()).isEqualTo(x1 - x0 + 1).isEqualTo(layers.width());
        assertThat(light.height()).isEqualTo(y1 - y0 + 1).isEqualTo(layers.height());
        for (int y = 0; y < light.height(); y++) {
          for (int x = 0; x < light.width(); x++) {
            long column = (long) x + x0 - left;
            long row = (long) y + y0 - top;
            boolean isStored = column >= 0 && column < WIDTH && row >= 0 && row < HEIGHT;
            float expected = isStored ? (float) value((int) column, (int) row) : 0;
            assertThat(light.pixel(x, y).r()).isEqualTo(expected);
            assertThat(light.pixel(x, y).b()).isEqualTo(4 * expected);
            assertThat(layers.layer("").orElseThrow().value(x, y, 3)).isEqualTo(isStored ? .5f : 0);
            assertThat(layers.layer("far").orElseThrow().value(x, y, 0)).isEqualTo(expected);
          }
        }
      }
    }
  }

  @Test
  void partsHaveWindowsOfTheirOwn() throws ImageFormatException {
    byte[] file =
        new ExrBuilder(WIDTH, HEIGHT, 3)
            .rgb("", ExrWindowTest::value)
            .windows(-2, -1, 0, 0, 3, 2)
            .fileBefore(new ExrBuilder(2, 2, 0).rgb("", (x, y) -> 0));
    Image light = ImageFormat.read(file, ImageReader.MAX_PIXELS).light();
    assertThat(light.width()).isEqualTo(4);
    assertThat(light.pixel(0, 0).r()).isEqualTo(value(2, 1));
  }

  /** The reference is the same picture without overscan. */
  @Test
  void overscanIsCutOff() throws IOException {
    Path cases = Path.of("src/test/resources/cases");
    Image image = LinearReader.read(cases.resolve("e_overscan.exr"));
    Image reference = LinearReader.read(cases.resolve("ref.pfm"));
    assertThat(image.width()).isEqualTo(reference.width());
    assertThat(image.rgb()).isEqualTo(reference.rgb());
  }
}
