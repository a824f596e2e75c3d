package io.github.lumbre.image.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.LayeredImage;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.format.exr.ExrBuilder;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Light and surfaces of OpenEXR files with alpha. */
class LinearPictureTest {
  private static final float[] ALPHA = {0, 1, .5f, -.01f, 1.01f, Float.NaN, 1e-30f, 0};
  private static final float[] STORED = {3, 3, 3, 3, 3, 3, 1e30f, 0};

  private static LinearPicture picture() throws ImageFormatException {
    byte[] file =
        new ExrBuilder(ALPHA.length, 1, 3)
            .rgb("", (x, y) -> STORED[x])
            .channel("A", 2, (x, y) -> ALPHA[x])
            .file();
    return ImageFormat.read(file, ImageReader.MAX_PIXELS);
  }

  @Test
  void lightIsWhatTheFileHas() throws ImageFormatException {
    Image light = picture().light();
    assertThat(light.hasAlpha()).isFalse();
    for (int x = 0; x < STORED.length; x++) {
      assertThat(light.pixel(x, 0)).isEqualTo(new Rgb(STORED[x], 2 * STORED[x], 4 * STORED[x]));
    }
  }

  @Test
  void colorsOfSurfacesAreDividedByAlphaAboveZero() throws ImageFormatException {
    Image straight = picture().straight();
    float[] expected = {3, 3, 6, 3, 3, 3, Float.MAX_VALUE, 0};
    float[] alpha = {0, 1, .5f, 0, 1, 0, 1e-30f, 0};
    for (int x = 0; x < STORED.length; x++) {
      assertThat((float) straight.pixel(x, 0).r()).as("pixel %s", x).isEqualTo(expected[x]);
      assertThat(straight.alpha(x, 0)).as("pixel %s", x).isEqualTo(alpha[x]);
    }
    assertThat(picture().clampedAlphas()).isEqualTo(3);
  }

  @Test
  void picturesWithoutAlphaAreBoth() throws ImageFormatException {
    byte[] file = new ExrBuilder(3, 2, 1).rgb("", (x, y) -> x + y).file();
    LinearPicture picture = ImageFormat.read(file, ImageReader.MAX_PIXELS);
    assertThat(picture.straight().hasAlpha()).isFalse();
    assertThat(picture.straight().rgb()).isSameAs(picture.light().rgb());
    assertThat(picture.clampedAlphas()).isZero();
  }

  /** Light where alpha is 0, such as a glow, too. Other colors differ by their rounding at most. */
  @Test
  void readingAndWritingKeepsTheFile(@TempDir Path folder) throws IOException {
    Image first = picture().straight();
    Path file = folder.resolve("a.exr");
    ImageWriter.write(first, file);
    LinearPicture second = LinearReader.open(file);
    for (int x = 0; x < STORED.length; x++) {
      assertThat(second.straight().alpha(x, 0)).isEqualTo(first.alpha(x, 0));
      float stored = x == 6 ? Float.MAX_VALUE * 1e-30f : STORED[x];
      assertThat((float) second.light().pixel(x, 0).r())
          .isCloseTo(stored, within(Math.ulp(stored)));
    }
    assertThat(second.light().pixel(0, 0)).isEqualTo(new Rgb(3, 6, 12));
    assertThat(second.straight().pixel(0, 0)).isEqualTo(new Rgb(3, 6, 12));
    assertThat(second.clampedAlphas()).isZero();
  }

  /** Layers have the numbers of the file, which another file has again, bit by bit. */
  @Test
  void layersKeepTheirBits(@TempDir Path folder) throws IOException {
    Image random = ImageFixture.random(7, 5, true);
    ImageLayer layer = ImageLayer.of(random);
    byte[] file =
        ImageFixture.written(random, folder.resolve("a.exr"), ImageWriter.Options.DEFAULT);
    assertThat(LayeredImage.of(file).layer("").orElseThrow().values()).isEqualTo(layer.values());
  }
}
