package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderResult;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Renders in one JVM share no settings and no counters. */
class RendersInOneJvmTest {
  private static final String MARBLE =
      "{\"id\": 9, \"assetType\": \"Texture\", \"textureType\": \"Marble\"}";

  @TempDir private Path directory;

  /** Returns the tiny scene with a marble texture whose coordinates are scaled. */
  private static String marble(String scale) {
    return TinyScene.withAsset(MARBLE)
        .replace(
            "\"Diffuse\",",
            "\"Diffuse\", \"colorTextureId\": 9, \"colorScale\": {\"x\": "
                + scale
                + ", \"y\": 1},");
  }

  private SceneFile parse(SceneParser parser, String json) {
    try {
      return parser.parse(TinyScene.write(directory, json));
    } catch (SceneFormatException | IOException e) {
      throw new AssertionError(e);
    }
  }

  private static RenderResult render(Scene scene, SceneFile file) throws InterruptedException {
    return new PictureRenderer(file.settings()).render(scene, Progress.NONE);
  }

  @Test
  void invalidTextureCoordinatesAreCountedForTheirOwnRender()
      throws InterruptedException, ExecutionException {
    SceneFile odd = parse(new SceneParser(), marble("1e308"));
    SceneFile sound = parse(new SceneParser(), marble("1000"));
    long expected = render(odd.scene(), odd).statistics().invalidCoordinates();
    assertThat(expected).isPositive();
    assertThat(render(sound.scene(), sound).statistics().invalidCoordinates()).isZero();
    ExecutorService threads = Executors.newFixedThreadPool(4);
    try {
      List<Future<RenderResult>> odds = new ArrayList<>();
      List<Future<RenderResult>> sounds = new ArrayList<>();
      for (int i = 0; i < 50; i++) {
        odds.add(threads.submit(() -> render(odd.scene(), odd)));
        sounds.add(threads.submit(() -> render(sound.scene(), sound)));
      }
      for (int i = 0; i < 50; i++) {
        assertThat(odds.get(i).get().statistics().invalidCoordinates()).isEqualTo(expected);
        assertThat(sounds.get(i).get().statistics().invalidCoordinates()).isZero();
      }
    } finally {
      threads.shutdownNow();
    }
  }

  /** Each scene has its own kernel, independent of other scenes in the JVM. */
  @Test
  void kernelsAreChosenForEachScene() throws InterruptedException {
    String mesh =
        "{\"id\": 9, \"assetType\": \"Mesh\", \"base64OBJ\":"
            + " \"diAwIDAgMAp2IDEgMCAwCnYgMCAxIDAKZiAxIDIgMwo=\"}";
    String object = "{\"type\": \"Shape\", \"shapeType\": \"Mesh\", \"meshId\": 9}, ";
    String json = TinyScene.withAsset(mesh).replace("{\"id\": 5", object + object + "{\"id\": 5");
    float[] expected = picture(new SceneParser(), json);
    Properties before = (Properties) System.getProperties().clone();
    for (Kernel kernel : Kernel.values()) {
      if (kernel != Kernel.VECTOR || Kernel.vectorObstacle().isEmpty()) {
        assertThat(picture(new SceneParser().searchedBy(kernel), json)).isEqualTo(expected);
      }
    }
    assertThat(System.getProperties()).isEqualTo(before);
  }

  @Test
  void flagLeavesNothingBehind() {
    Path scene = TinyScene.write(directory, TinyScene.JSON);
    String picture = directory.resolve("a.png").toString();
    Properties before = (Properties) System.getProperties().clone();
    assertThat(Outcome.of("render", "" + scene, "-o", picture, "--kernel", "scalar").exitCode())
        .isZero();
    assertThat(Outcome.of("pixel", "" + scene, "3,3", "--kernel", "scalar").exitCode()).isZero();
    assertThat(System.getProperties()).isEqualTo(before);
  }

  private float[] picture(SceneParser parser, String json) throws InterruptedException {
    SceneFile file = parse(parser, json);
    return render(file.scene(), file).image().rgb();
  }
}
