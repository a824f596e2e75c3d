package io.github.lumbre.model.format.gltf;

import static io.github.lumbre.testing.Near.assertNear;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelCamera;
import io.github.lumbre.model.internal.ModelFixture;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelPart;
import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the hierarchy of nodes in glTF. */
class GltfNodeTest {
  private static final double HALF = Math.sqrt(.5);

  private final GltfFile file = new GltfFile();

  private void node(String json) {
    file.add("nodes", json);
  }

  @Test
  void nodesScaleThenRotateThenTranslate() throws ModelFormatException, IOException {
    file.triangle("");
    node(
        "{'mesh': 0, 'translation': [1, 2, 3], 'rotation': [0, 0, %s, %s], 'scale': [2, 3, 4]}"
            .formatted(HALF, HALF));
    ModelPart part = file.read().parts().get(0);
    assertNear(part.toWorld().point(Vec3.ZERO), new Vec3(1, 2, 3), 1e-12);
    assertNear(part.toWorld().point(new Vec3(1, 1, 1)), new Vec3(1 - 3, 2 + 2, 3 + 4), 1e-12);
    assertThat(part.location()).isEqualTo("nodes[0].mesh.primitives[0]");
  }

  @Test
  void nodesArePartsOfTheNodesAbove() throws ModelFormatException, IOException {
    file.triangle("");
    node("{'name': 'car', 'children': [1, 2]}");
    node("{'children': [3]}");
    node("{'mesh': 0, 'name': 'door'}");
    node("{'mesh': 0}");
    List<ModelPart> parts = file.read().parts();
    assertThat(parts).extracting(part -> part.node().label()).containsExactly("door", "node 3");
    assertThat(parts).allMatch(part -> part.node().matches("car"::equals));
    assertThat(parts.get(0).node().matches("node 1"::equals)).isFalse();
    assertThat(parts.get(1).node().matches("node 1"::equals)).isTrue();
  }

  @Test
  void nodesOfOneNameAreHiddenTogetherAndSubtreesWithTheirRoot()
      throws ModelFormatException, IOException {
    file.triangle("");
    node("{'name': 'bolt', 'mesh': 0}");
    node("{'name': 'bolt', 'mesh': 0}");
    node("{'name': 'car', 'mesh': 0, 'children': [3]}");
    node("{'name': 'door', 'mesh': 0}");
    assertThat(left("bolt")).containsExactly("car", "door");
    assertThat(left("bolt 2")).containsExactly("bolt", "car", "door");
    assertThat(left("car")).containsExactly("bolt", "bolt 2");
    assertThat(left("door")).containsExactly("bolt", "bolt 2", "car");
  }

  private List<String> left(String hidden) throws ModelFormatException {
    ModelOptions options = ModelOptions.DEFAULT.with(ModelOption.HIDE, List.of(hidden));
    Model model = new ModelFixture("a.glb", file.glb()).with(options).read();
    return model.parts().stream().map(part -> part.node().label()).toList();
  }

  @Test
  void matricesAreStoredByColumns() throws ModelFormatException, IOException {
    file.triangle("");
    node("{'mesh': 0, 'matrix': [1, 2, 3, 0, 0, 5, 6, 0, 0, 0, 9, 0, 10, 11, 12, 1]}");
    ModelPart part = file.read().parts().get(0);
    assertThat(part.toWorld().point(Vec3.ZERO)).isEqualTo(new Vec3(10, 11, 12));
    assertThat(part.toWorld().vector(Vec3.X)).isEqualTo(new Vec3(1, 2, 3));
    assertThat(part.toWorld().vector(Vec3.Y)).isEqualTo(new Vec3(0, 5, 6));
    assertThat(part.toWorld().vector(Vec3.Z)).isEqualTo(new Vec3(0, 0, 9));
    assertNear(part.toWorld().inversePoint(new Vec3(10, 16, 18)), Vec3.Y, 1e-12);
  }

  @Test
  void childrenAreInTheSpaceOfTheirParent() throws ModelFormatException, IOException {
    file.triangle("");
    node("{'children': [1], 'translation': [5, 0, 0], 'scale': [2, 2, 2]}");
    node("{'mesh': 0, 'name': 'leaf', 'translation': [1, 0, 0]}");
    ModelPart part = file.read().parts().get(0);
    assertThat(part.toWorld().point(Vec3.X)).isEqualTo(new Vec3(9, 0, 0));
    assertThat(part.name()).isEqualTo("leaf");
  }

  /** KHR_node_visibility: with all nodes below, also those that say that they are visible. */
  @Test
  void hiddenNodesHaveNeitherMeshesNorLights() throws ModelFormatException, IOException {
    file.triangle("");
    file.add("cameras", "{'type': 'perspective', 'perspective': {'yfov': 1, 'znear': 1}}");
    file.set(
        "extensions",
        "{'KHR_lights_punctual': {'lights': [{'type': 'point'}, {'type': 'point'}]}}");
    file.set("extensionsRequired", "['KHR_node_visibility', 'KHR_lights_punctual']");
    String hidden = "'KHR_node_visibility': {'visible': false}";
    String shown = "'KHR_node_visibility': {'visible': true}";
    node("{'mesh': 0, 'children': [1, 2], 'extensions': {%s}}".formatted(hidden));
    node("{'mesh': 0, 'camera': 0, 'extensions': {%s}}".formatted(shown));
    node("{'extensions': {'KHR_lights_punctual': {'light': 0}}}");
    node("{'mesh': 0, 'extensions': {'KHR_node_visibility': {}}}");
    node("{'mesh': 0, 'extensions': {%s}}".formatted(shown));
    node("{'extensions': {'KHR_lights_punctual': {'light': 1}}}");
    Model model = file.read();
    assertThat(model.parts())
        .extracting(ModelPart::location)
        .containsExactly("nodes[3].mesh.primitives[0]", "nodes[4].mesh.primitives[0]");
    assertThat(model.cameras()).hasSize(1);
    assertThat(model.lights()).hasSize(1);
  }

  @Test
  void rotationsAreNormalized() throws ModelFormatException, IOException {
    file.triangle("");
    node("{'mesh': 0, 'rotation': [0, 0, 3, 3]}");
    assertNear(file.read().parts().get(0).toWorld().vector(Vec3.X), Vec3.Y, 1e-12);
  }

  @Test
  void nodesShareTheGeometryOfAMesh() throws ModelFormatException, IOException {
    file.triangle("");
    node("{'mesh': 0}");
    node("{'mesh': 0, 'translation': [1, 0, 0]}");
    List<ModelPart> parts = file.read().parts();
    assertThat(parts.get(0).geometry()).isSameAs(parts.get(1).geometry());
    assertThat(parts.get(0).material()).isSameAs(parts.get(1).material());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        // UniGLTF lists all nodes, which changes nothing.
        "[1]|[]|[0, 1, 2]|",
        "[1]|[]|[2, 1, 0]|",
        "[1]|[]|[0, 2, 0]|",
        "[1]|[]|[1, 2]|scenes[0].nodes[0]: expected a root node, found 1, a child of node 0;",
        "[1, 1]|[]|[0, 2]|nodes[0].children[1]: expected a node without a parent, found 1, a child"
            + " of node 0;",
        "[1]|[1]|[0, 2]|nodes[2].children[0]: expected a node without a parent, found 1, a child"
            + " of node 0;"
      })
  void nodesThatAreListedAgainAreShownOnce(
      String children, String others, String roots, String warning)
      throws ModelFormatException, IOException {
    file.triangle("");
    node("{'translation': [5, 0, 0], 'children': " + children + "}");
    node("{'mesh': 0, 'translation': [1, 0, 0]}");
    node("{'mesh': 0, 'translation': [0, 2, 0], 'children': " + others + "}");
    file.add("scenes", "{'nodes': " + roots + "}");
    Model model = file.read();
    assertThat(model.parts())
        .extracting(part -> part.toWorld().point(Vec3.ZERO))
        .containsExactly(new Vec3(6, 0, 0), new Vec3(0, 2, 0));
    assertThat(model.warnings()).hasSize(warning == null ? 0 : 1);
    assertThat(model.warnings()).allSatisfy(found -> assertThat(found).startsWith(warning));
  }

  private void threeScenes() {
    file.triangle("");
    node("{'mesh': 0, 'name': 'a'}");
    node("{'mesh': 0, 'name': 'b', 'children': [2]}");
    node("{'mesh': 0, 'name': 'c'}");
  }

  private List<String> names() throws ModelFormatException, IOException {
    return file.read().parts().stream().map(ModelPart::name).toList();
  }

  @Test
  void fileWithoutScenesShowsAllNodes() throws ModelFormatException, IOException {
    threeScenes();
    assertThat(names()).containsExactly("a", "b", "c");
  }

  @Test
  void defaultSceneIsShown() throws ModelFormatException, IOException {
    threeScenes();
    file.add("scenes", "{'nodes': [0]}");
    file.add("scenes", "{'nodes': [1]}");
    file.set("scene", "1");
    assertThat(names()).containsExactly("b", "c");
  }

  @Test
  void firstSceneIsShownIfThereIsNoDefault() throws ModelFormatException, IOException {
    threeScenes();
    file.add("scenes", "{'nodes': [0]}");
    file.add("scenes", "{'nodes': [1]}");
    assertThat(names()).containsExactly("a");
  }

  /** Whatever flattens it, rounding included, a mesh is shown as the plane that it becomes. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "{MESH, 'scale': [1, 0, 1]}",
        "{MESH, 'scale': [1000, 0, 0.001]}",
        "{MESH, 'scale': [-1, 0, 1]}",
        "{MESH, 'rotation': [0.1, 0.5, -0.1, 0.8544], 'scale': [1, 0, 1]}",
        "{'scale': [1, 0, 1], 'children': [1]}, {MESH, 'rotation': [0.6, 0, 0, 0.8]}",
        "{'rotation': [0.6, 0, 0, 0.8], 'children': [1]}, {'scale': [3, 0, 2], 'children': [2]},"
            + "{MESH, 'rotation': [0.3, 0.4, 0.5, 0.7071], 'translation': [1, 2, 3]}",
        "{MESH, 'matrix': [1,0,0,0, 0,0,0,0, 0,0,1,0, 4,5,6,1]}",
        "{MESH, 'matrix': [0.8137977,0.4698463,-0.3420201,0, 0,0,0,0,"
            + "0.4409696,-0.1631759,0.8825641,0, 0,0,0,1]}",
        "{MESH, 'matrix': [1,2,3,0, 2,4,6,0, 0.5,0,1,0, 0,0,0,1]}"
      })
  void flattenedMeshesAreShown(String nodes) throws ModelFormatException, IOException {
    int positions = file.floats("VEC3", 0, 0, 0, 1, 0, 0, .2, .4, -1, .1, .9, .3);
    int normals = file.floats("VEC3", 0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0);
    file.mesh(
        "'POSITION': " + positions + ", 'NORMAL': " + normals,
        ", 'indices': " + file.ints("SCALAR", 0, 1, 2, 2, 1, 3));
    // The mesh also has an instance that is not flattened.
    file.set("nodes", "[" + nodes.replace("MESH", "'mesh': 0") + ", {'mesh': 0}]");
    Model model = file.read();
    assertThat(model.warnings()).isEmpty();
    assertThat(model.parts()).hasSize(2);
    ModelGeometry plane = model.parts().get(0).geometry();
    assertThat(model.parts().get(1).geometry()).isNotSameAs(plane);
    assertThat(plane.isVisible()).isTrue();
    assertThat(plane.normals()).isEmpty();
    Vec3 normal = Vec3.ZERO;
    for (int i = 0; i < 6; i += 3) {
      Vec3 a = corner(model.parts().get(0), i);
      Vec3 e = corner(model.parts().get(0), i + 1).minus(a);
      Vec3 cross = e.cross(corner(model.parts().get(0), i + 2).minus(a));
      assertThat(cross.cross(normal).length()).isLessThan(1e-6 * cross.length());
      normal = cross.normalized();
    }
  }

  private static Vec3 corner(ModelPart part, int index) {
    double[] all = part.geometry().positions();
    int at = 3 * part.geometry().indices()[index];
    return part.toWorld().point(new Vec3(all[at], all[at + 1], all[at + 2]));
  }

  @Test
  void flattenedMeshesAreWhereTheirNodeMovesThem() throws ModelFormatException, IOException {
    file.triangle("");
    node("{'mesh': 0, 'scale': [2, 3, 0], 'translation': [1, 2, 3]}");
    ModelPart part = file.read().parts().get(0);
    assertThat(part.geometry().positions()).containsExactly(1, 2, 3, 3, 2, 3, 1, 5, 3);
    assertThat(part.toWorld().point(Vec3.X)).isEqualTo(Vec3.X);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "'scale': [0, 0, 1]",
        "'scale': [0, 0, 0]",
        "'rotation': [0.6, 0, 0, 0.8], 'scale': [0, 5, 0]",
        "'matrix': [1,2,3,0, 2,4,6,0, 3,6,9,0, 0,0,0,1]"
      })
  void meshesThatBecomeALineOrAPointAreLeftOut(String transform)
      throws ModelFormatException, IOException {
    file.triangle("");
    node("{'mesh': 0, " + transform + "}");
    node("{'mesh': 0}");
    Model model = file.read();
    assertThat(model.parts()).hasSize(1);
    assertThat(model.warnings())
        .containsExactly("nodes[0]: its transform is not invertible; its content is left out");
  }

  @ParameterizedTest
  @ValueSource(strings = {"'scale': [0, 1, 1]", "'matrix': [1,0,0,0, 2,0,0,0, 0,0,1,0, 0,0,0,1]"})
  void meshesWithoutAreaInTheirPlaneAreLeftOut(String transform)
      throws ModelFormatException, IOException {
    file.triangle("");
    node("{'mesh': 0, " + transform + "}");
    node("{'mesh': 0}");
    Model model = file.read();
    assertThat(model.parts()).hasSize(1);
    assertThat(model.warnings())
        .containsExactly("nodes[0].mesh.primitives[0]: is flattened to a line and left out");
  }

  /** A thin map is not a flat one. */
  @Test
  void thinMeshesStayInTheirSpace() throws ModelFormatException, IOException {
    file.triangle("");
    for (String scale :
        new String[] {"1, 0.00001, 1", "1000, 0.0005, 0.0005", "1e-9, 1e-9, 1e-9"}) {
      node("{'mesh': 0, 'scale': [" + scale + "]}");
    }
    Model model = file.read();
    assertThat(model.parts()).hasSize(3);
    for (ModelPart part : model.parts()) {
      assertThat(part.geometry()).isSameAs(model.parts().get(0).geometry());
    }
  }

  /** A scale of its node neither turns nor stretches a camera or a light. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "1, 1, 0",
        "1, 0, 1",
        "0, 1, 1",
        "0, 0, 0",
        "-1, 1, 1",
        "1, -1, 1",
        "1, 1, -1",
        "-2, -2, -2",
        "2, 3, 4",
        "1e-200, 1e-200, 1e-200"
      })
  void camerasAndLightsIgnoreTheirScales(String scale) throws ModelFormatException, IOException {
    file.set("extensions", "{'KHR_lights_punctual': {'lights': [{'type': 'spot', 'spot': {}}]}}");
    file.add("cameras", "{'type': 'orthographic', 'orthographic': {'xmag': 3, 'ymag': 2}}");
    String turned = "'rotation': [0.5, 0.5, 0.5, 0.5], 'scale': [" + scale + "]";
    node("{'extensions': {'KHR_lights_punctual': {'light': 0}}, " + turned + "}");
    node("{'camera': 0, 'translation': [1, 2, 3], " + turned + "}");
    Model model = file.read();
    Transform light = model.lights().get(0).toWorld();
    assertNear(light.vector(Vec3.Z).normalized(), Vec3.X, 1e-12);
    Transform camera = model.cameras().get(0).toWorld();
    assertNear(camera.vector(Vec3.Y), Vec3.Z, 1e-12);
    assertNear(camera.vector(Vec3.Z), Vec3.X, 1e-12);
    assertNear(camera.point(Vec3.ZERO), new Vec3(1, 2, 3), 1e-12);
    assertThat(model.cameras().get(0).aspect().getAsDouble()).isCloseTo(1.5, within(1e-12));
    assertThat(model.warnings()).isEmpty();
  }

  /** Scales above a camera move it, and mirrors turn it to what they mirror. */
  @ParameterizedTest
  @CsvSource({
    "'1, 1, -1', 0, 0, -5, -1",
    "'-2, -2, -2', 0, 0, -10, -1",
    "'-1, 1, 1', 0, 0, 5, 1",
    "'3, 3, 3', 0, 0, 15, 1",
    "'1, 1, 0', 0, 0, 0, 1"
  })
  void camerasFaceWhatTheirParentMirrors(
      String scale, double x, double y, double z, double backwards)
      throws ModelFormatException, IOException {
    file.add("cameras", "{'type': 'orthographic', 'orthographic': {'xmag': 3, 'ymag': 2}}");
    node("{'children': [1, 2], 'scale': [" + scale + "]}");
    node("{'camera': 0, 'translation': [0, 0, 5]}");
    node("{'camera': 0, 'translation': [0, 0, 5], 'scale': [1, 1, -1]}");
    for (ModelCamera camera : file.read().cameras()) {
      assertNear(camera.toWorld().point(Vec3.ZERO), new Vec3(x, y, z), 1e-12);
      assertNear(camera.toWorld().vector(Vec3.Z).times(backwards), Vec3.Z, 1e-12);
      assertThat(camera.toWorld().vector(Vec3.Y).length()).isCloseTo(1, within(1e-12));
    }
  }

  /** A matrix states no scale of its own: its directions count, as far as it has any. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "0,2,0,0, 0,0,2,0, 2,0,0,0, 7,0,0,1",
        "0,-2,0,0, 0,0,3,0, 4,0,0,0, 7,0,0,1",
        "0,0,0,0, 0,0,1,0, 1,0,0,0, 7,0,0,1",
        "0,1,0,0, 0,0,0,0, 1,0,0,0, 7,0,0,1",
        "0,1,0,0, 0,0,1,0, 0,0,0,0, 7,0,0,1"
      })
  void matricesOfCamerasKeepTheirDirections(String matrix)
      throws ModelFormatException, IOException {
    file.add("cameras", "{'type': 'orthographic', 'orthographic': {'xmag': 3, 'ymag': 2}}");
    node("{'camera': 0, 'matrix': [" + matrix + "]}");
    Transform toWorld = file.read().cameras().get(0).toWorld();
    assertNear(toWorld.vector(Vec3.X), Vec3.Y, 1e-12);
    assertNear(toWorld.vector(Vec3.Y), Vec3.Z, 1e-12);
    assertNear(toWorld.vector(Vec3.Z), Vec3.X, 1e-12);
    assertNear(toWorld.point(Vec3.ZERO), new Vec3(7, 0, 0), 1e-12);
  }

  @Test
  void mirroringTransformsKeepTheOutside() throws ModelFormatException, IOException {
    file.triangle("");
    node("{'mesh': 0, 'scale': [-1, 1, 1]}");
    ModelPart part = file.read().parts().get(0);
    assertThat(part.toWorld().isMirroring()).isTrue();
    assertThat(part.geometry().indices()).containsExactly(0, 1, 2);
    assertNear(part.toWorld().normal(Vec3.Z), Vec3.Z, 1e-12);
  }

  @Test
  void deepTreesAreRead() throws ModelFormatException, IOException {
    file.triangle("");
    for (int i = 0; i < 1999; i++) {
      node("{'children': [" + (i + 1) + "], 'translation': [1, 0, 0]}");
    }
    node("{'mesh': 0}");
    assertThat(file.read().parts().get(0).toWorld().point(Vec3.ZERO))
        .isEqualTo(new Vec3(1999, 0, 0));
  }
}
