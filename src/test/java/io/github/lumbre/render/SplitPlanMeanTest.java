package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Image;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneParser;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.testing.Effort;
import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Pictures of {@code --split auto} have the mean of pictures that are not split.
 *
 * <p>The means of ten renders of each kind are compared, in four parts of the frame. With 18
 * degrees of freedom, |t| exceeds 4.97 with a probability of 0.01 %, so that the test fails by
 * chance with less than 0.1 %.
 */
class SplitPlanMeanTest {
  private static final int RENDERS = 10;
  private static final double CRITICAL = 4.97;
  private static final int PARTS = 4;

  @ParameterizedTest
  @ValueSource(strings = {"cornell-box"})
  void thePlanKeepsTheMean(String name) throws Exception {
    double[][] whole = means(name, 1);
    double[][] auto = means(name, RenderSettings.AUTO_SPLIT);
    for (int part = 0; part < PARTS; part++) {
      double difference = Math.abs(mean(whole[part]) - mean(auto[part]));
      double error = Math.sqrt((variance(whole[part]) + variance(auto[part])) / RENDERS);
      assertThat(error).as("standard error").isLessThan(.02 * mean(whole[part]));
      assertThat(difference / error).as("%s, part %d", name, part).isLessThan(CRITICAL);
    }
  }

  /** Returns the mean radiance by part and render. */
  private static double[][] means(String name, int split) throws Exception {
    SceneFile file =
        new SceneParser()
            .overriding(
                s ->
                    s.toBuilder()
                        .size(96, 72)
                        .samples(Effort.count(8, 128))
                        .split(split)
                        .splitPilot(2048)
                        .build())
            .parse(Path.of("scenes", name + ".json"));
    double[][] means = new double[PARTS][RENDERS];
    boolean isSplit = false;
    for (int render = 0; render < RENDERS; render++) {
      long seed = Effort.seed(1000 * split + render);
      FilmRenderer renderer =
          new FilmRenderer(file.settings().toBuilder().seed(seed).build(), file.scene());
      Film film = renderer.newFilm();
      renderer.addSamples(film, file.settings().samples(), Progress.NONE);
      Image picture = film.develop();
      for (int y = 0; y < picture.height(); y++) {
        for (int x = 0; x < picture.width(); x++) {
          int part = (x < 48 ? 0 : 1) + (y < 36 ? 0 : 2);
          means[part][render] += picture.pixel(x, y).g() / (48 * 36);
        }
      }
      isSplit |= renderer.splitting().filter(report -> report.branches() > 1).isPresent();
    }
    assertThat(isSplit).isEqualTo(split == RenderSettings.AUTO_SPLIT);
    return means;
  }

  private static double mean(double[] values) {
    double sum = 0;
    for (double value : values) {
      sum += value;
    }
    return sum / values.length;
  }

  private static double variance(double[] values) {
    double sum = 0;
    for (double value : values) {
      sum += (value - mean(values)) * (value - mean(values));
    }
    return sum / (values.length - 1);
  }
}
