package io.github.lumbre.model.format.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.ModelScene;
import io.github.lumbre.model.internal.ModelSurface;
import java.io.IOException;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Copies of a mesh are placed as the extension has it, and share its arrays. */
class GltfInstancesTest {
  private static final int MANY = 12_000;

  private final GltfFile file = new GltfFile();

  private GltfFile withCopies(String attributes, String more) {
    String extension = "'extensions': {'EXT_mesh_gpu_instancing': {'attributes': {%s}}}";
    int mesh = file.triangle("");
    file.add("nodes", "{'mesh': " + mesh + ", " + extension.formatted(attributes) + more + "}");
    return file.set("extensionsRequired", "['EXT_mesh_gpu_instancing']");
  }

  private static String refusal(GltfFile file) {
    return catchThrowableOfType(ModelFormatException.class, file::read).getMessage();
  }

  @Test
  void copiesAreScaledRotatedAndMovedBeforeTheNode() throws ModelFormatException, IOException {
    int translation = file.floats("VEC3", 0, 0, 0, 1, 2, 3);
    int rotation = file.shorts(5122, "VEC4", ", 'normalized': true", 0, 0, 0, 32767, 0, 0, 9, 9);
    int scale = file.floats("VEC3", 1, 1, 1, 2, 3, 4);
    Model model =
        withCopies(
                "'TRANSLATION': %d, 'ROTATION': %d, 'SCALE': %d"
                    .formatted(translation, rotation, scale),
                ", 'translation': [10, 0, 0]")
            .read();
    assertThat(model.warnings()).isEmpty();
    assertThat(model.parts()).hasSize(2);
    assertThat(model.parts().get(0).toWorld().point(Vec3.X)).isEqualTo(new Vec3(11, 0, 0));
    Vec3 moved = model.parts().get(1).toWorld().point(new Vec3(1, 1, 1));
    assertThat(moved.minus(new Vec3(10 + 1 - 3, 2 + 2, 3 + 4)).length()).isLessThan(1e-12);
  }

  @Test
  void manyCopiesShareOneHierarchy() throws ModelFormatException, IOException {
    double[] places = IntStream.range(0, 3 * MANY).asDoubleStream().toArray();
    Model model = withCopies("'TRANSLATION': " + file.floats("VEC3", places), "").read();
    assertThat(model.parts()).hasSize(MANY);
    assertThat(model.parts().stream().map(ModelPart::geometry).distinct()).hasSize(1);
    ModelScene scene =
        new ModelScene(model, ModelScene.TO_LEFT_HANDED, Kernel.AUTO, Limits.NONE, false);
    List<ModelSurface> surfaces = scene.surfaces();
    assertThat(surfaces).hasSize(MANY);
    assertThat(surfaces).allMatch(surface -> surface.shape() instanceof MeshInstance);
    Vec3 lowest = surfaces.get(MANY - 1).shape().bounds().min();
    assertThat(lowest.x()).isCloseTo(3 * (MANY - 1), within(1e-6));
  }

  /** Returns points with colors and indices; a node has two copies of them. */
  private GltfFile withPoints() {
    String attributes =
        "'POSITION': %d, 'COLOR_0': %d"
            .formatted(
                file.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0),
                file.floats("VEC3", 1, 0, 0, 0, 1, 0, 0, 0, 1));
    int mesh = file.mesh(attributes, ", 'mode': 0, 'indices': " + file.ints("SCALAR", 2, 0, 2));
    int places = file.floats("VEC3", 0, 0, 0, 3, 0, 0);
    file.add(
        "nodes",
        "{'mesh': %d, 'extensions': {'EXT_mesh_gpu_instancing': {'attributes': {%s}}}}"
            .formatted(mesh, "'TRANSLATION': " + places));
    return file.set("extensionsUsed", "['EXT_mesh_gpu_instancing']");
  }

  @Test
  void mutantsOfPointsAreReadOrRefused() throws IOException {
    GltfMutationTest.checkMutants(withPoints().glb(), 0, 500);
  }

  @Test
  @Tag("fuzz")
  void manyMutantsOfPointsAreReadOrRefused() throws IOException {
    long seed = Long.getLong("lumbre.fuzz.seed", System.nanoTime());
    GltfMutationTest.checkMutants(withPoints().glb(), seed, 100_000);
  }

  @Test
  void attributesMustAgree() {
    int two = file.floats("VEC3", 0, 0, 0, 1, 2, 3);
    int one = file.floats("VEC3", 1, 1, 1);
    assertThat(refusal(withCopies("'TRANSLATION': " + two + ", 'SCALE': " + one, "")))
        .isEqualTo(
            "nodes[0].extensions.EXT_mesh_gpu_instancing.attributes.SCALE: expected 2 elements,"
                + " found 1");
  }

  @Test
  void attributesMustFit() {
    int zeros = file.floats("VEC4", 0, 0, 0, 0);
    String place = "nodes[0].extensions.EXT_mesh_gpu_instancing.attributes.";
    assertThat(refusal(withCopies("'ROTATION': " + zeros, "")))
        .isEqualTo(place + "ROTATION: expected unit quaternions, found zeros in element 0");
    GltfFile other = new GltfInstancesTest().withCopies("", "");
    assertThat(refusal(other)).isEqualTo(place + "TRANSLATION: expected an index, found nothing");
  }

  @Test
  void mutantsAreReadOrRefused() throws IOException {
    int translation = file.floats("VEC3", 0, 0, 0, 1, 2, 3);
    int rotation = file.bytes(5120, "VEC4", ", 'normalized': true", 0, 0, 0, 127, 0, 0, 9, 9);
    String attributes = "'TRANSLATION': " + translation + ", 'ROTATION': " + rotation;
    GltfMutationTest.checkMutants(withCopies(attributes, "").glb(), 0, 1000);
  }
}
