package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.compare.Flip;
import java.awt.image.Raster;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * A shadow on a transparent ground, as it looks over white, against the alpha of 4,096 samples per
 * pixel: {@code render box.off --ground --background transparent --no-denoise -s 4096 --seed 7}.
 */
class TransparentShadowTest {
  private static final Path EXPECTED =
      Path.of("src", "test", "resources", "io", "github", "lumbre", "cli", "box-shadow.png");

  private static final String BOX =
      """
      OFF
      8 6 0
      0 0 0  1 0 0  1 1 0  0 1 0  0 0 1  1 0 1  1 1 1  0 1 1
      4 3 2 1 0
      4 4 5 6 7
      4 0 1 5 4
      4 1 2 6 5
      4 2 3 7 6
      4 3 0 4 7
      """;

  @TempDir private Path folder;
  private double[] expected = {};

  @BeforeEach
  void write() throws IOException {
    Files.writeString(folder.resolve("box.off"), BOX);
    expected = alpha(EXPECTED);
  }

  private static double[] alpha(Path file) throws IOException {
    Raster raster = ImageIO.read(file.toFile()).getRaster();
    double[] alpha = new double[raster.getWidth() * raster.getHeight()];
    Arrays.setAll(
        alpha,
        i ->
            raster.getSampleDouble(
                    i % raster.getWidth(), i / raster.getWidth(), raster.getNumBands() - 1)
                / ((1 << raster.getSampleModel().getSampleSize(0)) - 1));
    return alpha;
  }

  /** Returns black of this alpha over white; the model is as expected. */
  private Image overWhite(double[] alpha, boolean[] isShadow) {
    float[] rgb = new float[3 * alpha.length];
    for (int i = 0; i < rgb.length; i++) {
      double shown = 1 - (isShadow[i / 3] ? alpha : expected)[i / 3];
      rgb[i] = (float) (shown <= .04045 ? shown / 12.92 : Math.pow((shown + .055) / 1.055, 2.4));
    }
    return new Image(64, 48, rgb, new float[0]);
  }

  /** Returns the mean of FLIP over the pixels that show the shadow alone. */
  private double flip(String flags) throws IOException {
    String render = "render T/box.off -o T/a.png --size 64x48 --bits 16 --overwrite";
    Outcome outcome =
        Outcome.in(folder, render + " --ground --background transparent" + flags).done();
    Raster picture = ImageIO.read(folder.resolve("a.png").toFile()).getRaster();
    boolean[] isShadow = new boolean[expected.length];
    for (int i = 0; i < expected.length; i++) {
      int light = 0;
      for (int band = 0; band < 3; band++) {
        light += picture.getSample(i % 64, i / 64, band);
      }
      isShadow[i] = light == 0 && expected[i] > .01 && expected[i] < .999;
    }
    double[] tiles =
        Flip.tiles(
            overWhite(alpha(folder.resolve("a.png")), isShadow), overWhite(expected, isShadow), 1);
    double sum = 0;
    int count = 0;
    for (int i = 0; i < tiles.length; i++) {
      sum += isShadow[i] ? tiles[i] : 0;
      count += isShadow[i] ? 1 : 0;
    }
    assertThat(count).isGreaterThan(500);
    return sum / count;
  }

  @Test
  void shadowsHaveLittleNoiseAtEightSamples() throws IOException {
    assertThat(flip("")).isLessThan(.03);
  }

  /** What denoising is measured against: the shadow of the same samples. */
  @Test
  void undenoisedShadowsAreCounts() throws IOException {
    assertThat(flip(" --no-denoise -s 8")).isGreaterThan(.1);
  }
}
