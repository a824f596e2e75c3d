package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.model.format.threemf.ThreeMfSample;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * A model without a point and without a visible triangle is refused, and the message names what was
 * left out.
 */
class EmptyModelsTest {
  private static final String NONE = "expected at least one triangle with an area, found none";

  private static final String PLY = "ply\nformat ascii 1.0\nelement vertex 3\n";
  private static final String XYZ = "property float x\nproperty float y\nproperty float z\n";
  private static final String FACES =
      "element face %d\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n2 0 0\n";

  @TempDir private Path folder;

  /** Returns a glTF file of one node and one mesh, whose vertices are (0,0,0), (1,0,0), (x,1,0). */
  private static String gltf(String primitive, String node, String more) {
    String positions = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    return """
    {"asset": {"version": "2.0"}, "nodes": [{"mesh": 0 %s}], "scenes": [{"nodes": [0]}],
     "meshes": [{"primitives": [{"attributes": {"POSITION": 0} %s}]}],
     "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3},
       {"componentType": 5126, "type": "VEC3", "count": 3},
       {"componentType": 5123, "type": "SCALAR", "count": 0}],
     "bufferViews": [{"buffer": 0, "byteLength": 36}],
     "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,%s"}] %s}
    """
        .formatted(node, primitive, positions, more);
  }

  private static Arguments of(String name, String content, String reason) {
    return of(name, content.getBytes(StandardCharsets.UTF_8), reason);
  }

  private static Arguments of(String name, byte[] content, String reason) {
    return Arguments.of(name, content, reason);
  }

  static Stream<Arguments> models() {
    String place = " (meshes[0].primitives[0]: ";
    String light =
        """
        , "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point"}]}},
        "extensionsUsed": ["KHR_lights_punctual"]
        """;
    String invented = ", \"extensionsUsed\": [\"ABC_compression\"]";
    return Stream.of(
        of(
            "no-points.gltf",
            gltf(", \"mode\": 0, \"indices\": 2", "", ""),
            place + "a mesh without points is left out)"),
        of("lines.gltf", gltf(", \"mode\": 1", "", ""), place + "lines are left out)"),
        of("strip.gltf", gltf(", \"mode\": 3", "", ""), place + "lines are left out)"),
        of(
            "no-indices.gltf",
            gltf(", \"indices\": 2", "", ""),
            place + "a mesh without triangles is left out)"),
        of(
            "no-positions.gltf",
            gltf("", "", "").replace("{\"POSITION\": 0}", "{}"),
            place + "a mesh without positions is left out)"),
        of("flat.gltf", gltf("", "", "").replace("AACAPw", "AAAAAA"), ""),
        of(
            "invented.gltf",
            gltf("", "", invented).replace("\"POSITION\": 0", "\"POSITION\": 1"),
            " (extensionsUsed: ABC_compression is not supported"),
        of(
            "point-scale.gltf",
            gltf("", ", \"scale\": [0, 0, 0]", ""),
            " (nodes[0]: its transform is not invertible; its content is left out)"),
        of(
            "other-scene.gltf",
            gltf("", "", "").replace("{\"nodes\": [0]}", "{}"),
            " (no visible node of the scene has a mesh; all meshes are left out)"),
        of("nothing.gltf", "{\"asset\": {\"version\": \"2.0\"}}", ""),
        of(
            "light.gltf",
            gltf(
                ", \"mode\": 1",
                ", \"extensions\": {\"KHR_lights_punctual\": {\"light\": 0}}",
                light),
            place + "lines are left out)"),
        of("nan.obj", "v nan 0 0\np 1\n", " (line 2: left out points that are not finite numbers"),
        of("lines.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n", " (line 3: ignored statements \"l\""),
        of("edges.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n", " (line 3: ignored faces of fewer than 3"),
        of("nothing.obj", "# nothing\n", ""),
        of(
            "flat.obj",
            "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n",
            " (line 4: dropped triangles of zero area: 1)"),
        of(
            "nan.ply",
            PLY + XYZ + "end_header\nnan 0 0\n1 nan 0\n2 0 inf\n",
            " (element vertex: left out points that are not finite numbers: 3)"),
        of(
            "no-indices.ply",
            PLY + XYZ + FACES.formatted(1).replace("vertex_indices", "x") + "3 0 1 2\n",
            "expected an element face or tristrips with a list vertex_indices"),
        of(
            "flat.ply",
            PLY + XYZ + FACES.formatted(1) + "3 0 1 2\n",
            " (dropped triangles of zero area: 1)"),
        of(
            "nan.off",
            "OFF\n2 0 0\nnan 0 0\n1 0 inf\n",
            " (left out points that are not finite numbers: 2)"),
        of(
            "edges.off",
            "OFF\n2 1 0\n0 0 0\n1 0 0\n2 0 1\n",
            " (line 5: ignored faces of fewer than 3"),
        of(
            "flat.off",
            "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n",
            " (line 6: dropped triangles of zero area: 1)"),
        of("nothing.3mf", ThreeMfSample.ofItems("", ""), ""),
        of(
            "support.3mf",
            ThreeMfSample.ofItems("<object id=\"1\" type=\"support\"/>", "<item objectid=\"1\"/>"),
            " (3D/root.model object 1: an object of type support is left out)"),
        of("nothing.stl", "solid\nendsolid\n", ""),
        of(
            "flat.stl",
            "solid\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 2 0 0"
                + " endloop endfacet\nendsolid\n",
            "dropped triangles of zero area: 1)"));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("models")
  void modelsThatShowNothingAreRefused(String name, byte[] content, String reason)
      throws IOException {
    Path model = folder.resolve(name);
    Files.write(model, content);
    String picture = folder.resolve("x.png").toString();
    for (String[] command :
        new String[][] {
          {"check", model.toString()},
          {"render", model.toString(), "-o", picture, "--size", "8x8", "-s", "1", "--quiet"}
        }) {
      Outcome outcome = Outcome.of(command);
      assertThat(outcome.exitCode()).as(Arrays.toString(command)).isEqualTo(ExitCodes.ASSET);
      assertThat(outcome.err()).contains(reason);
      if (!reason.startsWith("expected")) {
        String first = reason.startsWith(" (") ? reason : "";
        assertThat(outcome.err()).contains(name + ": " + NONE + first);
      }
    }
    assertThat(Path.of(picture)).doesNotExist();
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("models")
  void scenesRefuseThemUnlessTheyShine(String name, byte[] content, String reason)
      throws IOException {
    Files.write(folder.resolve(name), content);
    String scene =
        """
        {"mainCameraId": 1, "renderOptions": {"width": 8, "height": 8}, "objects": [
         {"type": "Camera", "id": 1, "cameraType": "Pinhole", "fieldOfView": 40},
         {"type": "Model", "file": "%s"}]}
        """;
    Files.writeString(folder.resolve("scene.json"), scene.formatted(name));
    Outcome outcome = Outcome.of("check", folder.resolve("scene.json").toString());
    assertThat(outcome.exitCode())
        .as(outcome.err())
        .isEqualTo(name.equals("light.gltf") ? ExitCodes.OK : ExitCodes.ASSET);
  }
}
