package io.github.lumbre.spark;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.StagedModel;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A bundle holds all that a scene needs. */
class SceneBundleTest {
  @TempDir private Path directory;

  @Test
  void aModelAndItsLibraryAreInTheBundle() throws Exception {
    Path model = directory.resolve("a.obj");
    Files.writeString(model, "mtllib a.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    Files.writeString(directory.resolve("a.mtl"), "newmtl red\nKd 1 0 0\n");
    Stage stage = Stage.DEFAULT.under(new Stage.Sky("white"));
    SceneFile scene = StagedModel.read(model, stage, new SceneParser()).scene();

    SceneBundle bundle = SceneBundle.of(model, scene);

    assertThat(bundle.assets()).containsOnlyKeys("a.obj", "a.mtl");
    assertThat(bundle.read().hash()).isEqualTo(scene.hash());
  }
}
