package io.github.lumbre.junit;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.image.Image;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.StagedModel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Random models have the same pixels with both kernels, 1 to 4 threads, and any JDK: run it twice
 * with -Dlumbre.golden.many=FOLDER.
 */
class ManyPicturesTest {
  private static final int TRIANGLES = 60;
  private static final int MAX_THREADS = 4;

  @TempDir private Path temporary;

  @Test
  void goldenPicturesOfRandomModelsMatch() throws Exception {
    int count = Integer.getInteger("lumbre.golden.count", 5);
    Path golden = Path.of(System.getProperty("lumbre.golden.many", temporary.toString()));
    GoldenSettings stores = new GoldenSettings(golden, temporary.resolve("report"), true);
    GoldenSettings compares = new GoldenSettings(golden, temporary.resolve("report"), false);
    int comparisons = 0;
    for (int i = 0; i < count; i++) {
      String name = "model-" + i;
      if (!GoldenFile.of(golden, name).exists()) {
        new PictureAssert(picture(i, Kernel.SCALAR, 1), stores).matches(name);
      }
      for (Kernel kernel : new Kernel[] {Kernel.SCALAR, Kernel.VECTOR}) {
        for (int threads = 1; threads <= MAX_THREADS; threads++) {
          Image picture = picture(i, kernel, threads);
          new PictureAssert(picture, compares).withTolerance(0).matches(name);
          comparisons++;
        }
      }
    }
    System.out.println("golden comparisons without a difference: " + comparisons);
    assertThat(comparisons).isEqualTo(8 * count);
  }

  private static Image picture(int number, Kernel kernel, int threads) throws Exception {
    SceneParser parser =
        new SceneParser()
            .searchedBy(kernel)
            .overriding(
                settings ->
                    settings.toBuilder()
                        .size(24, 18)
                        .samples(2)
                        .bucketSize(8)
                        .threads(threads)
                        .build());
    Stage.View view = new Stage.View(37 * number % 360, number % 60);
    Stage stage = Stage.DEFAULT.with(Stage.GROUND, true).seenFrom(view);
    byte[] obj = obj(new Random(number));
    SceneFile file =
        StagedModel.read("model.obj", obj, ModelFolder.NONE, stage, parser).scene();
    return new PictureRenderer(file.settings()).render(file.scene());
  }

  private static byte[] obj(Random random) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < 3 * TRIANGLES; i++) {
      text.append("v");
      for (int axis = 0; axis < 3; axis++) {
        text.append(' ').append(random.nextInt(1000) / 500.);
      }
      text.append('\n');
    }
    for (int i = 1; i < 3 * TRIANGLES; i += 3) {
      text.append("f ").append(i).append(' ').append(i + 1).append(' ').append(i + 2).append('\n');
    }
    return text.toString().getBytes(StandardCharsets.US_ASCII);
  }
}
