package io.github.lumbre.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.program.ImportProgram.Imported;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.StagedModel;
import io.github.lumbre.stage.internal.ModelSource;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.InputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
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

  /** As with {@code --assets}. */
  @Test
  void filesOutsideTheFolderOfAModelAreInTheBundle() throws Exception {
    Path folder = Files.createDirectories(directory.resolve("models/deep"));
    Path materials = Files.createDirectory(directory.resolve("materials"));
    Path model = folder.resolve("a.obj");
    Files.writeString(
        model, "mtllib ../../materials/a.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    Files.writeString(materials.resolve("a.mtl"), "newmtl red\nKd 1 0 0\n");
    Stage stage = Stage.DEFAULT.with(ModelOption.ASSETS, List.of(materials));
    SceneFile scene = StagedModel.read(model, stage, new SceneParser()).scene();

    SceneBundle bundle = SceneBundle.of(model, scene);

    assertThat(scene.warnings()).isEmpty();
    assertThat(bundle.assets()).containsOnlyKeys("models/deep/a.obj", "materials/a.mtl");
    assertThat(bundle.read().hash()).isEqualTo(scene.hash());
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void theFolderOfASceneMayBeALink() throws Exception {
    Path real = Files.createDirectory(directory.resolve("real"));
    Files.writeString(real.resolve("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    Files.writeString(
        real.resolve("a.json"),
        """
        {"mainCameraId": 1, "assets": [{"id": 1, "assetType": "Mesh", "file": "a.obj"},
          {"id": 2, "assetType": "Material", "materialType": "Diffuse"}],
         "objects": [{"id": 1, "type": "Camera", "cameraType": "Pinhole"},
          {"type": "Shape", "shapeType": "Mesh", "meshId": 1, "materialID": 2}]}
        """);
    Path scene = Files.createSymbolicLink(directory.resolve("link"), real).resolve("a.json");
    SceneFile read = new SceneParser().parse(scene);

    assertThat(SceneBundle.of(scene, read).read().hash()).isEqualTo(read.hash());
  }

  /** What the program has read stays where it is; what its result names travels, too. */
  @Test
  void aConvertedModelIsInTheBundleInsteadOfItsSource() throws Exception {
    Path model = directory.resolve("a.fbx");
    SceneFile scene = converted(model, GlbSample.bytes());

    SceneBundle bundle = SceneBundle.of(model, scene);

    assertThat(bundle.assets()).containsOnlyKeys("beside.png");
    SceneBundle arrived = sent(bundle);
    assertThat(arrived.read().hash()).isEqualTo(scene.hash());
    assertThat(arrived.identity()).isEqualTo(bundle.identity());
  }

  /** Returns the bundle as another process receives it. */
  private static SceneBundle sent(SceneBundle bundle) throws Exception {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(bundle);
    }
    InputStream received = new ByteArrayInputStream(bytes.toByteArray());
    try (ObjectInputStream in = new ObjectInputStream(received)) {
      return (SceneBundle) in.readObject();
    }
  }

  private SceneFile converted(Path model, byte[] glb) throws Exception {
    Files.writeString(model, "a model");
    GlbSample.write(directory.resolve("sheet.glb"));
    Imported imported = Imported.of(glb, new byte[] {1, 2, 3});
    return ModelSource.converted(new SceneParser(), model, imported).scene(Stage.DEFAULT);
  }

  @Test
  void anExecutorWithAnotherConversionIsRefused() throws Exception {
    Path model = directory.resolve("a.fbx");
    SceneBundle bundle = SceneBundle.of(model, converted(model, GlbSample.bytes()));
    bundle.converted().get(0).glb()[100] ^= 1;
    assertThatThrownBy(bundle::read)
        .isInstanceOf(IllegalStateException.class)
        .hasMessageMatching(
            "a.fbx: the executor's converted model has the hash \\w{64}, expected the driver's .*");
  }

  /** A program may convert the same model differently: an executor keeps both apart. */
  @Test
  void conversionsOfOneModelHaveDifferentIdentities() throws Exception {
    Path model = directory.resolve("a.fbx");
    byte[] glb = GlbSample.bytes();
    SceneBundle bundle = SceneBundle.of(model, converted(model, glb.clone()));
    assertThat(SceneBundle.of(model, converted(model, glb.clone())).identity())
        .isEqualTo(bundle.identity());
    // A byte of the first position.
    glb[glb.length - 124] ^= 1;
    SceneBundle other = SceneBundle.of(model, converted(model, glb));
    assertThat(other.hash()).isEqualTo(bundle.hash());
    assertThat(other.identity()).isNotEqualTo(bundle.identity());
  }
}
