package io.github.lumbre.render.stopping;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Image;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.testing.Effort;
import java.nio.file.Path;
import java.util.Locale;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The mean of adaptive pictures over many seeds equals that of non-adaptive ones, in the whole
 * picture and in each of twelve regions.
 *
 * <p>A z-score of 4.2 or more in any of the 13 tests occurs by chance once in 2900 runs. The
 * results are printed, and published in docs/trade.md.
 */
@Tag(Effort.EXHAUSTIVE)
class AdaptiveBiasTest {
  private static final int WIDTH = 24;
  private static final int HEIGHT = 18;
  private static final int COLUMNS = 4;
  private static final int ROWS = 3;
  private static final int SAMPLES = 128;
  private static final int RENDERS = 600;
  private static final double LARGEST_SCORE = 4.2;

  /** The sums of a region's light over several renders. */
  private static final class Sums {
    private double sum;
    private double squares;

    double mean() {
      return sum / RENDERS;
    }

    double squaredError() {
      return (squares / RENDERS - mean() * mean()) / (RENDERS - 1);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"glass-and-mirror", "camera-thin-lens", "cornell-box"})
  void adaptivePicturesHaveTheMeanOfEvenOnes(String name) throws Exception {
    SceneFile file = new SceneParser().parse(Path.of("scenes", name + ".json"));
    RenderSettings settings =
        file.settings().toBuilder().size(WIDTH, HEIGHT).threads(0).samples(SAMPLES).build();
    Sums[] even = sums(file, settings, 0);
    Sums[] adaptive = sums(file, settings.toBuilder().adaptive(true).build(), RENDERS);
    double worst = 0;
    for (int i = 0; i < even.length; i++) {
      worst = Math.max(worst, Math.abs(score(even[i], adaptive[i])));
    }
    Sums all = even[even.length - 1];
    Sums own = adaptive[even.length - 1];
    System.out.printf(
        Locale.ROOT,
        "%s: bias %.3f %% +- %.3f %% of the light, largest z of the regions %.2f%n",
        name,
        100 * (own.mean() / all.mean() - 1),
        196 * Math.sqrt(own.squaredError() + all.squaredError()) / all.mean(),
        worst);
    assertThat(worst).isLessThan(LARGEST_SCORE);
  }

  private static double score(Sums a, Sums b) {
    return (b.mean() - a.mean()) / Math.sqrt(a.squaredError() + b.squaredError());
  }

  /** Returns the sums of each region, followed by those of the whole picture. */
  private static Sums[] sums(SceneFile file, RenderSettings settings, int firstSeed)
      throws InterruptedException {
    Sums[] sums = new Sums[ROWS * COLUMNS + 1];
    for (int i = 0; i < sums.length; i++) {
      sums[i] = new Sums();
    }
    for (int k = 0; k < RENDERS; k++) {
      RenderSettings own = settings.toBuilder().seed(Effort.seed(firstSeed + k)).build();
      double[] light = light(new PictureRenderer(own).render(file.scene()));
      for (int i = 0; i < sums.length; i++) {
        sums[i].sum += light[i];
        sums[i].squares += light[i] * light[i];
      }
    }
    return sums;
  }

  private static double[] light(Image picture) {
    double[] light = new double[ROWS * COLUMNS + 1];
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        double luminance = picture.pixel(x, y).luminance();
        light[y * ROWS / HEIGHT * COLUMNS + x * COLUMNS / WIDTH] += luminance;
        light[ROWS * COLUMNS] += luminance;
      }
    }
    return light;
  }
}
