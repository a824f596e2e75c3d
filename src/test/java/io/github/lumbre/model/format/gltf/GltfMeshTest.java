package io.github.lumbre.model.format.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelPart;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the reading of accessors and primitives of glTF. */
class GltfMeshTest {
  private final GltfFile file = new GltfFile();

  private String triangle() {
    return "'POSITION': " + file.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
  }

  /** Adds some vertices on a line, and returns them as an attribute. */
  private String vertices(int count) {
    double[] positions = new double[3 * count];
    for (int i = 0; i < count; i++) {
      positions[3 * i] = i;
    }
    return "'POSITION': " + file.floats("VEC3", positions);
  }

  @Test
  void meshWithoutIndicesUsesVerticesInOrder() throws ModelFormatException, IOException {
    file.meshNode(triangle(), "");
    ModelGeometry mesh = file.geometry();
    assertThat(mesh.positions()).containsExactly(0, 0, 0, 1, 0, 0, 0, 1, 0);
    assertThat(mesh.indices()).containsExactly(0, 1, 2);
    assertThat(mesh.normals()).isEmpty();
    assertThat(mesh.tangents()).isEmpty();
    assertThat(mesh.uv0()).isEmpty();
    assertThat(mesh.uv1()).isEmpty();
    assertThat(mesh.colors()).isEmpty();
  }

  @Test
  void indicesHaveThreeTypes() throws ModelFormatException, IOException {
    String positions = triangle();
    int[] accessors = {
      file.bytes(5121, "SCALAR", "", 2, 1, 0),
      file.shorts(5123, "SCALAR", "", 2, 1, 0),
      file.ints("SCALAR", 2, 1, 0)
    };
    for (int accessor : accessors) {
      file.meshNode(positions, ", 'indices': " + accessor);
    }
    for (ModelPart part : file.read().parts()) {
      assertThat(part.geometry().indices()).containsExactly(2, 1, 0);
    }
  }

  @ParameterizedTest
  @CsvSource({"4, 0 1 2 3 4 5", "5, 0 1 2 1 3 2 2 3 4 3 5 4", "6, 1 2 0 2 3 0 3 4 0 4 5 0"})
  void triangleModesBecomeLists(int mode, String expected)
      throws ModelFormatException, IOException {
    file.meshNode(vertices(6), ", 'mode': " + mode);
    assertThat(file.geometry().indices())
        .containsExactly(Arrays.stream(expected.split(" ")).mapToInt(Integer::parseInt).toArray());
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3})
  void linesAreLeftOut(int mode) throws ModelFormatException, IOException {
    file.meshNode(vertices(6), ", 'mode': " + mode);
    Model model = file.read();
    assertThat(model.parts()).isEmpty();
    assertThat(model.warnings()).containsExactly("meshes[0].primitives[0]: lines are left out");
  }

  @Test
  void incompleteTrianglesAreLeftOut() throws ModelFormatException, IOException {
    file.meshNode(vertices(5), "");
    Model model = file.read();
    assertThat(model.parts().get(0).geometry().indices()).containsExactly(0, 1, 2);
    assertThat(model.warnings())
        .containsExactly(
            "meshes[0].primitives[0]: expected three corners per triangle, found 5 corners in"
                + " all");
  }

  @Test
  void integersAreQuantizedNumbers() throws ModelFormatException, IOException {
    int bytes = file.bytes(5120, "VEC3", "", -1, 2, 127, 4, -128, 6, 7, 8, 9);
    int shorts = file.shorts(5122, "VEC3", "", -1, 2, 32767, 4, -32768, 6, 7, 8, 9);
    int unsigned = file.shorts(5123, "VEC3", "", 65535, 2, 3, 4, 5, 6, 7, 8, 9);
    file.meshNode("'POSITION': " + bytes, "");
    file.meshNode("'POSITION': " + shorts, "");
    file.meshNode("'POSITION': " + unsigned, "");
    Model model = file.read();
    assertThat(model.parts().get(0).geometry().positions())
        .containsExactly(-1, 2, 127, 4, -128, 6, 7, 8, 9);
    assertThat(model.parts().get(1).geometry().positions())
        .containsExactly(-1, 2, 32767, 4, -32768, 6, 7, 8, 9);
    assertThat(model.parts().get(2).geometry().positions())
        .containsExactly(65535, 2, 3, 4, 5, 6, 7, 8, 9);
  }

  @ParameterizedTest
  @CsvSource({
    "5120, 1, 127, 1",
    "5120, 1, -127, -1",
    "5120, 1, -128, -1",
    "5121, 1, 255, 1",
    "5121, 1, 51, .2",
    "5122, 2, 32767, 1",
    "5122, 2, -32768, -1",
    "5123, 2, 65535, 1",
    "5123, 2, 13107, .2"
  })
  void normalizedIntegersAreFractions(int component, int size, int value, double expected)
      throws ModelFormatException, IOException {
    int[] values = {value, 0, 0, 0, 0, 0, 0, 0, 0};
    String more = ", 'normalized': true";
    int accessor =
        size == 1
            ? file.bytes(component, "VEC3", more, values)
            : file.shorts(component, "VEC3", more, values);
    file.meshNode("'POSITION': " + accessor, "");
    assertThat(file.geometry().positions()[0]).isEqualTo(expected);
  }

  @Test
  void interleavedVerticesAreTakenApart() throws ModelFormatException, IOException {
    ByteBuffer data = ByteBuffer.allocate(60).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < 3; i++) {
      data.putFloat(i).putFloat(10 + i).putFloat(20 + i);
      data.putFloat(i / 4f).putFloat(i / 8f);
    }
    int view = file.view(data.array(), ", 'byteStride': 20");
    file.add(
        "accessors",
        "{'bufferView': %d, 'componentType': 5126, 'type': 'VEC3', 'count': 3}".formatted(view));
    file.add(
        "accessors",
        "{'bufferView': %d, 'byteOffset': 12, 'componentType': 5126, 'type': 'VEC2', 'count': 3}"
            .formatted(view));
    file.meshNode("'POSITION': 0, 'TEXCOORD_0': 1", "");
    ModelGeometry mesh = file.geometry();
    assertThat(mesh.positions()).containsExactly(0, 10, 20, 1, 11, 21, 2, 12, 22);
    assertThat(mesh.uv0()).containsExactly(0, 1, .25, .875, .5, .75);
  }

  @Test
  void accessorWithoutViewIsZero() throws ModelFormatException, IOException {
    file.add("accessors", "{'componentType': 5126, 'type': 'VEC2', 'count': 3}");
    file.meshNode(triangle() + ", 'TEXCOORD_0': 0", "");
    assertThat(file.geometry().uv0()).containsExactly(0, 1, 0, 1, 0, 1);
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void sparseElementsReplaceOthers(boolean hasView) throws ModelFormatException, IOException {
    int indices = file.view(new byte[] {0, 2}, "");
    ByteBuffer values = ByteBuffer.allocate(24).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < 6; i++) {
      values.putFloat(10 + i);
    }
    int view = file.view(values.array(), "");
    ByteBuffer base = ByteBuffer.allocate(36).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < 9; i++) {
      base.putFloat(i);
    }
    String source = hasView ? "'bufferView': " + file.view(base.array(), "") + "," : "";
    file.add(
        "accessors",
        """
        {%s 'componentType': 5126, 'type': 'VEC3', 'count': 3, 'sparse': {'count': 2,
          'indices': {'bufferView': %d, 'componentType': 5121}, 'values': {'bufferView': %d}}}
        """
            .formatted(source, indices, view));
    file.meshNode("'POSITION': 0", "");
    assertThat(file.geometry().positions())
        .containsExactly(
            hasView
                ? new double[] {10, 11, 12, 3, 4, 5, 13, 14, 15}
                : new double[] {10, 11, 12, 0, 0, 0, 13, 14, 15});
  }

  @Test
  void normalsAndTangentsAreKept() throws ModelFormatException, IOException {
    int normals = file.floats("VEC3", 0, 0, 1, 0, 0, 1, 0, 0, 1);
    int tangents = file.floats("VEC4", 1, 0, 0, 1, 1, 0, 0, -1, 1, 0, 0, 1);
    file.meshNode(triangle() + ", 'NORMAL': " + normals + ", 'TANGENT': " + tangents, "");
    ModelGeometry mesh = file.geometry();
    assertThat(mesh.normals()).containsExactly(0, 0, 1, 0, 0, 1, 0, 0, 1);
    assertThat(mesh.tangents()).containsExactly(1, 0, 0, 1, 1, 0, 0, -1, 1, 0, 0, 1);
  }

  @Test
  void roundedNormalsHaveUnitLength() throws ModelFormatException, IOException {
    int normals = file.bytes(5120, "VEC3", ", 'normalized': true", 3, 0, 4, 0, 100, 0, 0, 0, 0);
    file.meshNode(triangle() + ", 'NORMAL': " + normals, "");
    double[] expected = {.6, 0, .8, 0, 1, 0, 0, 0, 0};
    assertThat(file.geometry().normals()).containsExactly(expected, within(1e-15));
  }

  @Test
  void infiniteNormalsAreIgnored() throws ModelFormatException, IOException {
    int normals = file.floats("VEC3", 0, 0, 1, 0, Double.NaN, 1, 0, 0, 1);
    file.meshNode(triangle() + ", 'NORMAL': " + normals, "");
    Model model = file.read();
    assertThat(model.parts().get(0).geometry().normals()).isEmpty();
    assertThat(model.warnings())
        .containsExactly("accessors[0]: NaN or infinite numbers; NORMAL is ignored");
  }

  @Test
  void textureCoordinatesGrowUpwards() throws ModelFormatException, IOException {
    int first = file.floats("VEC2", 0, 0, .25, .75, 1, 1);
    int second = file.shorts(5123, "VEC2", ", 'normalized': true", 0, 0, 13107, 65535, 65535, 0);
    file.meshNode(triangle() + ", 'TEXCOORD_0': " + first + ", 'TEXCOORD_1': " + second, "");
    ModelGeometry mesh = file.geometry();
    assertThat(mesh.uv0()).containsExactly(0, 1, .25, .25, 1, 0);
    assertThat(mesh.uv1()).containsExactly(0, 1, .2, 0, 1, 1);
  }

  @Test
  void colorsAreLinearFractions() throws ModelFormatException, IOException {
    int[] accessors = {
      file.floats("VEC3", .5, 0, 1, .5, 0, 2, .5, -1, 1),
      file.floats("VEC4", .5, 0, 1, 1, .5, 0, 1, 1, .5, 0, 1, 1),
    };
    for (int accessor : accessors) {
      file.meshNode(triangle() + ", 'COLOR_0': " + accessor, "");
    }
    for (ModelPart part : file.read().parts()) {
      assertThat(part.geometry().colors())
          .containsExactly(.5f, 0f, 1f, 1f, .5f, 0f, 1f, 1f, .5f, 0f, 1f, 1f);
    }
  }

  @Test
  void integerColorsAreFractionsOfTheLargestInteger() throws ModelFormatException, IOException {
    int bytes = file.bytes(5121, "VEC4", "", 255, 51, 0, 102, 0, 0, 0, 0, 0, 0, 0, 0);
    int shorts =
        file.shorts(
            5123, "VEC4", ", 'normalized': true", 65535, 13107, 0, 26214, 0, 0, 0, 0, 0, 0, 0, 0);
    file.meshNode(triangle() + ", 'COLOR_0': " + bytes, "");
    file.meshNode(triangle() + ", 'COLOR_0': " + shorts, "");
    for (ModelPart part : file.read().parts()) {
      assertThat(part.geometry().colors()).startsWith(1f, .2f, 0f, .4f);
    }
  }

  @Test
  void primitivesShareArrays() throws ModelFormatException, IOException {
    String positions = triangle();
    file.meshNode(positions, "");
    file.meshNode(positions, "");
    Model model = file.read();
    assertThat(model.parts().get(0).geometry().positions())
        .isSameAs(model.parts().get(1).geometry().positions());
  }
}
