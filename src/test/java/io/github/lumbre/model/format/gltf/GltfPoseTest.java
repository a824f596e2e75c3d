package io.github.lumbre.model.format.gltf;

import static io.github.lumbre.testing.Near.assertNear;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelAnimation;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelPart;
import java.io.IOException;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests animations, morph targets and skins of glTF. */
class GltfPoseTest {
  private static final double HALF = Math.sqrt(.5);

  private final GltfFile file = new GltfFile();

  private static ModelOptions at(String animation, double seconds) {
    return new ModelOptions(
        Optional.of(new ModelOptions.Pose(animation, seconds)),
        Optional.empty(),
        ModelOptions.Up.Y,
        1);
  }

  /** Adds an animation of node 0. */
  private void animate(String name, String path, String interpolation, int input, int output) {
    file.add(
        "animations",
        """
        {%s 'channels': [{'sampler': 0, 'target': {'node': 0, 'path': '%s'}}],
          'samplers': [{'input': %d, 'output': %d, 'interpolation': '%s'}]}
        """
            .formatted(name, path, input, output, interpolation));
  }

  private Vec3 origin(double seconds) throws ModelFormatException, IOException {
    return file.read(at("0", seconds)).parts().get(0).toWorld().point(Vec3.ZERO);
  }

  private Vec3 xAxis(double seconds) throws ModelFormatException, IOException {
    return file.read(at("0", seconds)).parts().get(0).toWorld().vector(Vec3.X);
  }

  private void addNode() {
    file.triangle("");
    file.add("nodes", "{'mesh': 0, 'translation': [9, 9, 9], 'scale': [2, 2, 2]}");
  }

  @ParameterizedTest
  @CsvSource({
    "STEP, 0, 1",
    "STEP, 1, 1",
    "STEP, 2.5, 1",
    "STEP, 3, 5",
    "STEP, 4, 5",
    "STEP, 5, 2",
    "LINEAR, 0, 1",
    "LINEAR, 1, 1",
    "LINEAR, 2.5, 4",
    "LINEAR, 4, 3.5",
    "LINEAR, 1e9, 2"
  })
  void translationsFollowTheirKeyframes(String interpolation, double seconds, double expected)
      throws ModelFormatException, IOException {
    addNode();
    int input = file.floats("SCALAR", 1, 3, 5);
    int output = file.floats("VEC3", 1, 0, 7, 5, 0, 7, 2, 0, 7);
    animate("", "translation", interpolation, input, output);
    assertThat(origin(seconds)).isEqualTo(new Vec3(expected, 0, 7));
  }

  @ParameterizedTest
  @CsvSource({"0, 0", "1, 1.5", "2, 4", "3, 4"})
  void splinesAreCubic(double seconds, double expected) throws ModelFormatException, IOException {
    addNode();
    int input = file.floats("SCALAR", 0, 2);
    int output = file.floats("VEC3", 9, 9, 9, 0, 0, 0, 1, 0, 0, 3, 0, 0, 4, 0, 0, 9, 9, 9);
    animate("", "translation", "CUBICSPLINE", input, output);
    assertThat(origin(seconds)).isEqualTo(new Vec3(expected, 0, 0));
  }

  @ParameterizedTest
  @CsvSource({"1", "-1"})
  void rotationsFollowTheShorterArc(int sign) throws ModelFormatException, IOException {
    addNode();
    int input = file.floats("SCALAR", 0, 3);
    int output = file.floats("VEC4", 0, 0, 0, 1, 0, 0, sign * HALF, sign * HALF);
    animate("", "rotation", "LINEAR", input, output);
    assertNear(xAxis(1), new Vec3(Math.sqrt(3), 1, 0), 1e-6);
    assertNear(xAxis(2), new Vec3(1, Math.sqrt(3), 0), 1e-6);
    assertNear(xAxis(3), new Vec3(0, 2, 0), 1e-6);
  }

  @Test
  void equalRotationsStay() throws ModelFormatException, IOException {
    addNode();
    int input = file.floats("SCALAR", 0, 1);
    animate("", "rotation", "LINEAR", input, file.floats("VEC4", 0, 0, 1, 0, 0, 0, 1, 0));
    assertNear(xAxis(.25), new Vec3(-2, 0, 0), 1e-6);
  }

  @Test
  void splinesOfRotationsHaveUnitLength() throws ModelFormatException, IOException {
    addNode();
    int input = file.floats("SCALAR", 0, 1);
    int output =
        file.floats("VEC4", 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0);
    animate("", "rotation", "CUBICSPLINE", input, output);
    assertNear(xAxis(.5), new Vec3(0, 2, 0), 1e-6);
  }

  @Test
  void integerRotationsAreFractions() throws ModelFormatException, IOException {
    addNode();
    int input = file.floats("SCALAR", 0);
    int output = file.shorts(5122, "VEC4", ", 'normalized': true", 0, 0, 32767, 0);
    animate("", "rotation", "STEP", input, output);
    assertNear(xAxis(0), new Vec3(-2, 0, 0), 1e-6);
  }

  @Test
  void scalesAreAnimated() throws ModelFormatException, IOException {
    addNode();
    animate("", "scale", "LINEAR", file.floats("SCALAR", 0), file.floats("VEC3", 3, 4, 5));
    assertThat(xAxis(0)).isEqualTo(new Vec3(3, 0, 0));
  }

  @Test
  void animationsAreChosenByNameOrNumber() throws ModelFormatException, IOException {
    addNode();
    int input = file.floats("SCALAR", 0);
    animate("'name': 'walk',", "translation", "STEP", input, file.floats("VEC3", 1, 0, 0));
    animate("", "translation", "STEP", input, file.floats("VEC3", 2, 0, 0));
    Model rest = file.read();
    assertThat(rest.animations()).extracting(ModelAnimation::name).containsExactly("walk", "1");
    assertThat(rest.parts().get(0).toWorld().point(Vec3.ZERO)).isEqualTo(new Vec3(9, 9, 9));
    for (String name : new String[] {"walk", "0", "1"}) {
      Vec3 found = file.read(at(name, 0)).parts().get(0).toWorld().point(Vec3.ZERO);
      assertThat(found).isEqualTo(new Vec3(name.equals("1") ? 2 : 1, 0, 0));
    }
  }

  @Test
  void unknownPathsAndMatricesStayAtRest() throws ModelFormatException, IOException {
    file.triangle("");
    file.add("nodes", "{'mesh': 0, 'matrix': [1,0,0,0, 0,1,0,0, 0,0,1,0, 4,0,0,1]}");
    int input = file.floats("SCALAR", 0);
    int output = file.floats("VEC3", 1, 0, 0);
    animate("", "translation", "STEP", input, output);
    animate("", "pointer", "STEP", input, output);
    assertThat(origin(0)).isEqualTo(new Vec3(4, 0, 0));
    assertThat(file.read(at("0", 0)).warnings())
        .containsExactly(
            "animations[0].channels[0].target.node: a node with a matrix is not animated; left at"
                + " rest");
    file.set("nodes", "[{'mesh': 0}]");
    assertThat(file.read(at("1", 0)).warnings())
        .containsExactly(
            "animations[1].channels[0].target.path: expected translation, rotation, scale or"
                + " weights, found \"pointer\"; left at rest");
  }

  /** Adds a triangle with two morph targets: 2 along z, and 3 along x. */
  private void addMorphs(String weights) {
    int normals = file.floats("VEC3", 0, 0, 1, 0, 0, 1, 0, 0, 1);
    int tangents = file.floats("VEC4", 1, 0, 0, -1, 1, 0, 0, -1, 1, 0, 0, -1);
    int z = file.floats("VEC3", 0, 0, 2, 0, 0, 2, 0, 0, 2);
    int x = file.floats("VEC3", 3, 0, 0, 3, 0, 0, 3, 0, 0);
    int y = file.floats("VEC3", 0, 1, 0, 0, 1, 0, 0, 1, 0);
    int base = file.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
    file.add(
        "meshes",
        """
        {'primitives': [{'attributes': {'POSITION': %d, 'NORMAL': %d, 'TANGENT': %d}, 'targets':
          [{'POSITION': %d}, {'POSITION': %d, 'NORMAL': %d, 'TANGENT': %d}]}]%s}
        """
            .formatted(base, normals, tangents, z, x, y, y, weights));
  }

  @Test
  void targetsMoveVerticesByWeight() throws ModelFormatException, IOException {
    addMorphs(", 'weights': [0.5, 1]");
    file.add("nodes", "{'mesh': 0}");
    file.add("nodes", "{'mesh': 0}");
    file.add("nodes", "{'mesh': 0, 'weights': [1, 0]}");
    file.add("nodes", "{'mesh': 0, 'weights': [0, 0]}");
    Model model = file.read();
    ModelGeometry mesh = model.parts().get(0).geometry();
    assertThat(mesh.positions()).containsExactly(3, 0, 1, 4, 0, 1, 3, 1, 1);
    assertThat(mesh.normals()).startsWith(new double[] {0, HALF, HALF}, within(1e-15));
    assertThat(mesh.tangents()).startsWith(new double[] {HALF, HALF, 0, -1}, within(1e-15));
    assertThat(model.parts().get(1).geometry()).isSameAs(mesh);
    assertThat(model.parts().get(2).geometry().positions())
        .containsExactly(0, 0, 2, 1, 0, 2, 0, 1, 2);
    assertThat(model.parts().get(3).geometry().positions())
        .containsExactly(0, 0, 0, 1, 0, 0, 0, 1, 0);
  }

  @Test
  void sparseTargetsMoveSomeVertices() throws ModelFormatException, IOException {
    int indices = file.view(new byte[] {1}, "");
    int values = file.floats("VEC3", 0, 0, 4);
    int delta =
        file.add(
            "accessors",
            """
            {'componentType': 5126, 'type': 'VEC3', 'count': 3, 'sparse': {'count': 1,
              'indices': {'bufferView': %d, 'componentType': 5121},
              'values': {'bufferView': %d}}}
            """
                .formatted(indices, indices + 1));
    file.triangle(", 'targets': [{'POSITION': " + delta + "}]");
    file.add("nodes", "{'mesh': 0, 'weights': [0.5]}");
    assertThat(values).isZero();
    assertThat(file.geometry().positions()).containsExactly(0, 0, 0, 1, 0, 2, 0, 1, 0);
  }

  @ParameterizedTest
  @CsvSource({"LINEAR, .5", "STEP, 0"})
  void weightsAreAnimated(String interpolation, double expected)
      throws ModelFormatException, IOException {
    addMorphs(", 'weights': [9, 9]");
    file.add("nodes", "{'mesh': 0}");
    int input = file.floats("SCALAR", 0, 1);
    animate("", "weights", interpolation, input, file.floats("SCALAR", 0, 0, 1, 2));
    double[] positions = file.read(at("0", .5)).parts().get(0).geometry().positions();
    assertThat(positions).startsWith(6 * expected, 0, 2 * expected);
  }

  /** Adds a triangle that two joints move: 10 along x, and 20 along y. */
  private void addSkin(String skin, String node, String attributes) {
    file.add("nodes", "{'mesh': 0, 'skin': 0" + node + "}");
    file.add("nodes", "{'translation': [10, 0, 0]}");
    file.add("nodes", "{'translation': [0, 20, 0]}");
    file.add("skins", "{'joints': [1, 2]" + skin + "}");
    int joints = file.bytes(5121, "VEC4", "", 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 9, 9);
    int weights = file.floats("VEC4", 1, 0, 0, 0, 1, 0, 0, 0, .5, .5, 0, 0);
    int base = file.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
    file.mesh(
        "'POSITION': %d, 'JOINTS_0': %d, 'WEIGHTS_0': %d%s"
            .formatted(base, joints, weights, attributes),
        "");
  }

  @Test
  void jointsMoveVertices() throws ModelFormatException, IOException {
    addSkin("", ", 'translation': [100, 0, 0]", "");
    ModelPart part = file.read().parts().get(0);
    assertThat(part.geometry().positions()).containsExactly(10, 0, 0, 1, 20, 0, 5, 11, 0);
    assertThat(part.geometry().indices()).containsExactly(0, 1, 2);
    assertThat(part.toWorld().point(Vec3.X)).isEqualTo(Vec3.X);
  }

  @Test
  void inverseBindMatricesApplyFirst() throws ModelFormatException, IOException {
    int matrices =
        file.floats(
            "MAT4", 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, -3, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0,
            1, 0, 0, 0, 5, 1);
    addSkin(", 'inverseBindMatrices': " + matrices, "", "");
    assertThat(file.geometry().positions()).containsExactly(7, 0, 0, 1, 20, 5, 3.5, 11.5, 2.5);
  }

  @Test
  void furtherJointsCount() throws ModelFormatException, IOException {
    int joints = file.shorts(5123, "VEC4", "", 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
    int weights = file.bytes(5121, "VEC4", "", 255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
    addSkin("", "", ", 'JOINTS_1': " + joints + ", 'WEIGHTS_1': " + weights);
    assertThat(file.geometry().positions()).startsWith(5, 10, 0);
  }

  @Test
  void mirroredSkinsReverseTheirTriangles() throws ModelFormatException, IOException {
    addSkin("", ", 'scale': [-1, 1, 1]", "");
    assertThat(file.geometry().indices()).containsExactly(0, 2, 1);
  }

  @Test
  void jointsMoveNormalsAndTangents() throws ModelFormatException, IOException {
    int normals = file.floats("VEC3", 0, .6, .8, 0, 0, 1, 0, 0, 1);
    int tangents = file.floats("VEC4", 0, -.8, .6, -1, 1, 0, 0, 1, 1, 0, 0, 1);
    addSkin("", "", ", 'NORMAL': " + normals + ", 'TANGENT': " + tangents);
    file.set("nodes", "[{'mesh': 0, 'skin': 0}, {'scale': [1, 1, 2]}, {'scale': [1, 1, -1]}]");
    ModelGeometry mesh = file.geometry();
    double length = Math.hypot(.6, .4);
    assertThat(mesh.normals())
        .startsWith(new double[] {0, .6 / length, .4 / length, 0, 0, -1}, within(1e-6));
    double stretched = Math.hypot(.8, 1.2);
    assertThat(mesh.tangents())
        .startsWith(new double[] {0, -.8 / stretched, 1.2 / stretched, -1}, within(1e-6));
  }

  @Test
  void meshWithoutJointsStaysInItsNode() throws ModelFormatException, IOException {
    file.triangle("");
    file.add("nodes", "{'mesh': 0, 'skin': 0, 'translation': [3, 0, 0]}");
    file.add("skins", "{'joints': [0]}");
    assertThat(file.read().parts().get(0).toWorld().point(Vec3.ZERO)).isEqualTo(new Vec3(3, 0, 0));
  }
}
