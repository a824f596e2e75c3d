package io.github.lumbre.stage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.Image;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage.View;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The standard views of a model, in one run and over releases. */
class StagedModelTest {
  /** A part with a different shape from each side: three boxes of different heights. */
  private static final String PART =
      box(0, 0, 0, 4, 1, 3, 0) + box(0, 1, 0, 1, 3, 1, 1) + box(3, 1, 2, 4, 2, 3, 2);

  /** Hashes of the pixels of the standard views. */
  private static final Map<String, String> STORED = new LinkedHashMap<>();

  static {
    STORED.put("front", "f2da2c05");
    STORED.put("back", "e775f75b");
    STORED.put("left", "9423e715");
    STORED.put("right", "d1eac3c7");
    STORED.put("top", "432e4744");
    STORED.put("bottom", "67b93c26");
    STORED.put("iso", "898a7f10");
  }

  @TempDir private Path directory;

  private static String box(int x0, int y0, int z0, int x1, int y1, int z1, int number) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < 8; i++) {
      text.append("v ").append((i & 1) == 0 ? x0 : x1);
      text.append(' ').append((i & 2) == 0 ? y0 : y1);
      text.append(' ').append((i & 4) == 0 ? z0 : z1).append('\n');
    }
    int[][] faces = {
      {1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5}, {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}
    };
    for (int[] face : faces) {
      text.append("f");
      for (int corner : face) {
        text.append(' ').append(corner + 8 * number);
      }
      text.append('\n');
    }
    return text.toString();
  }

  private Path part() throws Exception {
    return Files.writeString(directory.resolve("part.obj"), PART, StandardCharsets.US_ASCII);
  }

  private static SceneParser parser() {
    return new SceneParser()
        .overriding(settings -> settings.toBuilder().size(32, 24).samples(2).build());
  }

  private static Image picture(RenderSettings settings, Scene scene)
      throws InterruptedException {
    return new PictureRenderer(settings).render(scene);
  }

  @Test
  void viewsOfOneRunHaveTheBitsOfSingleRenders() throws Exception {
    Path part = part();
    for (Stage stage : List.of(Stage.DEFAULT, Stage.DEFAULT.with(Stage.GROUND, true))) {
      List<View> views = List.copyOf(View.standard().values());
      StagedModel all = StagedModel.read(part, stage.seenFrom(views.get(0)), parser());
      List<Scene> scenes = all.seenFrom(views);
      assertThat(scenes).hasSize(7);
      for (int i = 0; i < views.size(); i++) {
        SceneFile single =
            StagedModel.read(part, stage.seenFrom(views.get(i)), parser()).scene();
        assertThat(all.scene().settings()).isEqualTo(single.settings());
        assertThat(picture(single.settings(), scenes.get(i)).rgb())
            .as(views.get(i).toString())
            .isEqualTo(picture(single.settings(), single.scene()).rgb());
      }
    }
  }

  /**
   * Pictures of the standard views are the same in all releases. A change of these numbers is a
   * change that the changelog must state.
   */
  @Test
  void standardViewsAreStableOverReleases() throws Exception {
    Stage stage = Stage.DEFAULT.with(Stage.GROUND, true).seenFrom(View.of("front"));
    StagedModel all = StagedModel.read(part(), stage, parser());
    List<Scene> scenes = all.seenFrom(List.copyOf(View.standard().values()));
    Map<String, String> found = new LinkedHashMap<>();
    int i = 0;
    for (String name : View.standard().keySet()) {
      Image image = picture(all.scene().settings(), scenes.get(i++));
      found.put(name, Integer.toHexString(Arrays.hashCode(image.rgb())));
    }
    assertThat(found).isEqualTo(STORED);
  }

  @Test
  void viewsAreNamed() {
    assertThat(View.of("iso")).isEqualTo(new View(45, 35.264389682754654, false, true));
    assertThat(View.of("-40,15")).isEqualTo(new View(-40, 15));
    assertThatThrownBy(() -> View.of("20")).hasMessageContaining("found 20");
    assertThatThrownBy(() -> View.of("0,91")).hasMessageContaining("from -90 to 90, found 91");
    assertThat(View.standard()).hasSize(7);
  }

  /** The hash is that of the bytes that were read, whatever becomes of the arrays. */
  @Test
  void hashesAreThoseOfWhatWasRead() throws Exception {
    byte[] model = ("mtllib a.mtl\n" + PART).getBytes(StandardCharsets.US_ASCII);
    byte[] colors = "newmtl a\nKd 1 0 0\n".getBytes(StandardCharsets.US_ASCII);
    ModelFolder folder = ModelFolder.of(Map.of("a.mtl", colors));
    String expected =
        StagedModel.read("part.obj", model, folder, Stage.DEFAULT, parser()).scene().hash();
    for (byte[] changed : List.of(model, colors)) {
      SceneFile scene =
          StagedModel.read("part.obj", model, folder, Stage.DEFAULT, parser()).scene();
      byte last = changed[changed.length - 1];
      changed[changed.length - 1] = '#';
      assertThat(scene.hash()).isEqualTo(expected);
      changed[changed.length - 1] = last;
    }
  }
}
