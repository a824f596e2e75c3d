package io.github.lumbre.model.format.gltf;

import static io.github.lumbre.material.MaterialParameter.BASE_COLOR;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelPart;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Base64;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What is damaged in a glTF file is left out with a warning if the rest can be shown. */
class GltfDamageTest {
  private static final ModelOptions LENIENT = ModelOptions.DEFAULT.mayLackFiles(true);
  private static final String LOST = "left out faces with a vertex that is not a finite number: ";

  private final GltfFile file = new GltfFile();

  private static Model read(byte[] gltf, ModelOptions options)
      throws ModelFormatException, IOException {
    return GltfReader.read(gltf, GltfFile.EMPTY, options);
  }

  /** Adds five vertices in a zigzag, the last of which is broken. */
  private int zigzag(double broken) {
    return file.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, broken, 1);
  }

  @ParameterizedTest
  @CsvSource({
    "4, 0 1 2 2 1 3 2 3 4, 0 1 2 2 1 3, 1",
    "4, 4 1 2 2 1 3 2 3 4, 2 1 3, 2",
    "5, 0 1 2 3 4, 0 1 2 1 3 2, 1",
    "6, 0 1 3 4 2, 1 3 0, 2",
    "4, 0 1 2, 0 1 2, 0",
  })
  void trianglesThatTouchBrokenVerticesAreLeftOut(int mode, String all, String kept, int lost)
      throws ModelFormatException, IOException {
    int[] corners = numbers(all);
    int indices = file.shorts(5123, "SCALAR", "", corners);
    String more = ", 'mode': " + mode + ", 'indices': " + indices;
    for (double broken : new double[] {Double.NaN, 1 / 0., -1 / 0.}) {
      file.meshNode("'POSITION': " + zigzag(broken), more);
    }
    Model model = file.read();
    assertThat(model.parts()).hasSize(3);
    for (ModelPart part : model.parts()) {
      assertThat(part.geometry().indices()).containsExactly(numbers(kept));
      assertThat(Arrays.stream(part.geometry().positions()).allMatch(Double::isFinite)).isTrue();
    }
    assertThat(model.warnings()).hasSize(lost == 0 ? 0 : 3);
    assertThat(model.warnings()).allMatch(text -> text.endsWith("primitives[0]: " + LOST + lost));
  }

  private static int[] numbers(String text) {
    return Arrays.stream(text.split(" ")).mapToInt(Integer::parseInt).toArray();
  }

  /** Primitives that share positions lack the same triangles. */
  @Test
  void sharedPositionsAreBrokenForAllPrimitives() throws ModelFormatException, IOException {
    int positions = zigzag(Double.NaN);
    for (String corners : new String[] {"0 1 2 2 3 4", "1 2 3 4 2 3"}) {
      int indices = file.shorts(5123, "SCALAR", "", numbers(corners));
      file.meshNode("'POSITION': " + positions, ", 'indices': " + indices);
    }
    Model model = file.read();
    assertThat(model.parts().get(0).geometry().indices()).containsExactly(0, 1, 2);
    assertThat(model.parts().get(1).geometry().indices()).containsExactly(1, 2, 3);
    assertThat(model.warnings()).hasSize(2);
  }

  @Test
  void meshOfBrokenTrianglesAloneIsLeftOut() throws ModelFormatException, IOException {
    file.meshNode("'POSITION': " + file.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 1 / 0.), "");
    file.add("nodes", "{'mesh': " + file.triangle("") + "}");
    Model model = file.read();
    assertThat(model.parts()).hasSize(1);
    assertThat(model.warnings())
        .containsExactly(
            "meshes[0].primitives[0]: " + LOST + 1,
            "meshes[0].primitives[0]: a mesh without triangles is left out");
  }

  /** Of two triangles, a morph target breaks one; without its weight it breaks none. */
  @ParameterizedTest
  @CsvSource({"1, 3", "0, 6"})
  void trianglesThatAMorphTargetBreaksAreLeftOut(double weight, int corners)
      throws ModelFormatException, IOException {
    int moves = file.floats("VEC3", 0, 0, 1, 0, 0, 1, 0, 0, 1, Double.NaN, 0, 0);
    String attributes = "'POSITION': " + file.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0);
    int indices = file.shorts(5123, "SCALAR", "", 0, 1, 2, 2, 1, 3);
    String more = ", 'indices': %d, 'targets': [{'POSITION': %d}]".formatted(indices, moves);
    int mesh = file.mesh(attributes, more);
    file.add("nodes", "{'mesh': %d, 'weights': [%s]}".formatted(mesh, weight));
    Model model = file.read();
    assertThat(model.parts().get(0).geometry().indices()).hasSize(corners);
    assertThat(model.warnings()).hasSize(corners == 6 ? 0 : 1);
    assertThat(model.parts().get(0).geometry().positions()[2]).isEqualTo(weight);
  }

  @Test
  void brokenNormalsOfAMorphTargetAreIgnored() throws ModelFormatException, IOException {
    int up = file.floats("VEC3", 0, 0, 1, 0, 0, 1, 0, 0, 1);
    int broken = file.floats("VEC3", 0, 0, 1, 0, 1 / 0., 1, 0, 0, 1);
    String attributes =
        "'POSITION': %d, 'NORMAL': %d"
            .formatted(file.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0), up);
    int mesh = file.mesh(attributes, ", 'targets': [{'NORMAL': " + broken + "}]");
    file.add("nodes", "{'mesh': %d, 'weights': [1]}".formatted(mesh));
    Model model = file.read();
    assertThat(model.parts().get(0).geometry().normals())
        .containsExactly(0, 0, 1, 0, 0, 1, 0, 0, 1);
    assertThat(model.warnings())
        .containsExactly("accessors[1]: NaN or infinite numbers; NORMAL is ignored");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "data:image/png;base64,AAA*",
        "data:image/png;base64,A",
        "data:image/png;base64",
        "data:image/png,%zz",
        "50%.png",
        "",
        "missing.png"
      })
  void texturesWithoutReadableDataAreLeftOut(String uri) throws ModelFormatException, IOException {
    file.add("images", "{'uri': '" + uri + "'}");
    file.add("textures", "{'source': 0}");
    for (int i = 0; i < 2; i++) {
      file.add("materials", "{'pbrMetallicRoughness': {'baseColorTexture': {'index': 0}}}");
      file.add("nodes", "{'mesh': " + file.triangle(", 'material': " + i) + "}");
    }
    Model model = file.read(LENIENT);
    assertThat(model.parts()).hasSize(2);
    assertThat(model.parts())
        .allMatch(part -> part.material().input(BASE_COLOR).texture().isEmpty());
    assertThat(model.warnings()).hasSize(1);
    assertThat(model.warnings().get(0)).matches("images\\[0].uri: .*; the picture is left out");
    assertThatThrownBy(file::read)
        .isInstanceOfSatisfying(
            ModelFormatException.class, e -> assertThat(e.kind()).isEqualTo(Kind.ASSET));
  }

  /** Of two meshes, the second needs a buffer whose URI is damaged. */
  @ParameterizedTest
  @CsvSource({
    "'data:;base64,AAA*', 'expected base64, found other characters'",
    "'data:;base64', 'expected a comma in a data URI, found none'",
    "'b.bin', 'no file b.bin'"
  })
  void meshesWithoutReadableBuffersAreLeftOut(String uri, String problem)
      throws ModelFormatException, IOException {
    Model model = read(twoBuffers(dataUri(), uri), LENIENT);
    assertThat(model.parts()).hasSize(1);
    assertThat(model.parts().get(0).location()).isEqualTo("nodes[0].mesh.primitives[0]");
    assertThat(model.warnings())
        .containsExactly(
            "nodes[1].mesh.primitives[0]: buffers[1].uri: " + problem + "; the mesh is left out");
    for (byte[] nothing : new byte[][] {twoBuffers(uri, uri), twoBuffers(uri, "data:;base64,A")}) {
      assertRefused(nothing, LENIENT, "buffers[0].uri: " + problem);
    }
    assertRefused(twoBuffers(dataUri(), uri), ModelOptions.DEFAULT, "buffers[1].uri: " + problem);
  }

  private static void assertRefused(byte[] gltf, ModelOptions options, String message) {
    assertThatThrownBy(() -> read(gltf, options))
        .hasMessage(message)
        .isInstanceOfSatisfying(
            ModelFormatException.class, e -> assertThat(e.kind()).isEqualTo(Kind.ASSET));
  }

  private static String dataUri() {
    byte[] triangle = GltfFile.ofTriangle().buffer();
    return "data:;base64," + Base64.getEncoder().encodeToString(triangle);
  }

  private static byte[] twoBuffers(String first, String second) {
    return """
    {"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}, {"mesh": 1}],
     "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]},
       {"primitives": [{"attributes": {"POSITION": 1}}]}],
     "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3},
       {"bufferView": 1, "componentType": 5126, "type": "VEC3", "count": 3}],
     "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 1, "byteLength": 36}],
     "buffers": [{"byteLength": 36, "uri": "%s"}, {"byteLength": 36, "uri": "%s"}]}
    """
        .formatted(first, second)
        .getBytes(StandardCharsets.UTF_8);
  }
}
