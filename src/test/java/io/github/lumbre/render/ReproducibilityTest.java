package io.github.lumbre.render;

import static io.github.lumbre.testing.Folders.scenes;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Image;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * For the same scene, seed and samples, pictures are bit-identical for any division of the work.
 */
class ReproducibilityTest {
  private static final int[] THREADS = {1, 2, 3, 8, 64};
  private static final int[] BUCKETS = {1, 7, 32, 10_000};

  @Test
  void thereAreAtLeastTenScenes() throws IOException {
    assertThat(scenes()).hasSizeGreaterThanOrEqualTo(10);
  }

  @ParameterizedTest
  @MethodSource("io.github.lumbre.testing.Folders#scenes")
  void threadsBucketsAndTheirOrderDoNotChangeABit(Path path)
      throws SceneFormatException, IOException, InterruptedException {
    Random random = new Random(43);
    for (RenderSettings.Mode mode : RenderSettings.Mode.values()) {
      SceneFile file =
          new SceneParser()
              .inMode(mode)
              .overriding(s -> s.toBuilder().size(40, 29).samples(2).build())
              .parse(path);
      float[] expected = new PictureRenderer(file.settings()).render(file.scene()).rgb();
      for (int threads : THREADS) {
        for (int bucket : BUCKETS) {
          RenderSettings settings =
              file.settings().toBuilder().threads(threads).bucketSize(bucket).build();
          FilmRenderer renderer = new FilmRenderer(settings, file.scene());
          Image image =
              new PictureRenderer(settings)
                  .render(renderer.inOrder(Orders.shuffled(random)), Progress.NONE)
                  .image();
          assertThat(image.rgb())
              .as("%s %d threads, bucket %d, shuffled", mode, threads, bucket)
              .isEqualTo(expected);
        }
      }
    }
  }
}
