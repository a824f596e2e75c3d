package io.github.lumbre.model.format.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.ModelReader;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the messages about damaged, unsupported and too large glTF files. */
class GltfErrorsTest {
  private static final String ASSET = "\"asset\": {\"version\": \"2.0\"}";

  /** 36 bytes: a triangle (0, 0, 0), (1, 0, 0), (0, 1, 0). */
  private static final String TRIANGLE =
      """
      "buffers": [{"byteLength": 36, "uri": "data:;base64,\
      AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
      """;

  private static ModelFormatException refusal(byte[] content, ModelOptions options) {
    return catchThrowableOfType(
        ModelFormatException.class,
        () -> ModelReader.read("a.gltf", content, GltfFile.EMPTY, options));
  }

  private static ModelFormatException refusal(String text) {
    return refusal(text.getBytes(StandardCharsets.UTF_8), ModelOptions.DEFAULT);
  }

  private static void check(String text, Kind kind, String message) {
    ModelFormatException e = refusal(text);
    assertThat(e).hasMessage(message);
    assertThat(e.kind()).isEqualTo(kind);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "`` | expected a glTF file, found an empty file",
        "[] | expected a JSON object, found an array",
        "{} | asset: expected an object, found nothing",
        "{'a': [1, {'b': 1e999}]} | a[1].b: expected a finite number, found 1e999",
        "{'a': {'b': 1, 'b': 2}}"
            + " | a.b: expected each key once, found it on line 1 and on line 1",
        "{'a': {'b': {}, 'c': 3, 'b': {}}}"
            + " | a.b: expected each key once, found it on line 1 and on line 1",
        "{'a': nul} | a: expected JSON (RFC 8259), found nul without double quotes at line 1,"
            + " column 7",
        "{'a': NaN} | a: expected JSON (RFC 8259), found NaN without double quotes at line 1,"
            + " column 7",
        "{'a': [1, | a[1]: expected more JSON, found the end of the file at line 1, column 10",
        "{'a': 1} x | expected JSON (RFC 8259), found x without double quotes at line 1, column 11",
        "{'asset': 2} | asset: expected an object, found 2",
        "{'asset': {}} | asset.version: expected a version such as 2.0, found nothing",
        "{'asset': {'version': 2}} | asset.version: expected a text, found 2",
        "{'asset': {'version': 'two'}}"
            + " | asset.version: expected a version such as 2.0, found \"two\""
      })
  void damagedJsonIsRefused(String json, String message) {
    check(json.replace('\'', '"'), Kind.MALFORMED, message);
  }

  /** In a GLB, the JSON begins after two headers. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "{'a': [1, 2,]} | a[2]: | a comma after the last element at line 1, column 14",
        "`{'ä': 1,\n\n }` | ä: | a comma after the last element at line 3, column 3",
        "{'😀': [1, 2,]} | 😀[2]: | a comma after the last element at line 1, column 15",
        "`{\n// x\n}` || a comment, which JSON does not have, at line 2, column 2",
        "{a: 1} || a without double quotes at line 1, column 3",
        "{'a' 1} | a: | no colon after a key at line 1, column 7",
        "{'a': 1 'b': 2} | a: | no comma between two elements at line 1, column 10",
        "{'a': @b@} | a: | single quotes instead of double quotes at line 1, column 8",
        "{'a': 'b} | a: | a string without its closing quotes at line 1, column 10",
        "{'a': 01} | a: | a syntax error at line 1, column 7"
      })
  void frequentMistakesInJsonAreNamed(String json, String place, String found) {
    String text = json.replace('\'', '"').replace('@', '\'');
    String where = place == null ? "" : place + " ";
    String message = where + "expected JSON (RFC 8259), found " + found;
    check(text, Kind.MALFORMED, message);
    assertThat(refusal(("\ufeff" + text).getBytes(StandardCharsets.UTF_8), ModelOptions.DEFAULT))
        .hasMessage(message);
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    ByteBuffer glb = ByteBuffer.allocate(20 + bytes.length).order(ByteOrder.LITTLE_ENDIAN);
    glb.putInt(0x46546c67).putInt(2).putInt(20 + bytes.length).putInt(bytes.length);
    glb.putInt(0x4e4f534a).put(bytes);
    assertThat(refusal(glb.array(), ModelOptions.DEFAULT)).hasMessage(message);
  }

  @Test
  void invalidBytesAreRefused() {
    byte[] text = "{\"a\": \"?\"}".getBytes(StandardCharsets.US_ASCII);
    text[7] = (byte) 0xff;
    assertThat(refusal(text, ModelOptions.DEFAULT))
        .hasMessage("expected UTF-8, found invalid bytes");
  }

  @Test
  void deepNestingIsRefused() {
    ModelFormatException e = refusal("{\"a\":" + "[".repeat(300));
    assertThat(e.kind()).isEqualTo(Kind.TOO_LARGE);
    assertThat(e).hasMessageEndingWith("expected at most 256 nested JSON values, found more");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "'asset': {'version': '1.0'} | asset.version: expected 2.0, found \"1.0\"",
        "'asset': {'version': '3.0'} | asset.version: expected 2.0, found \"3.0\"",
        "'asset': {'version': '2.1', 'minVersion': '2.1'}"
            + " | asset.minVersion: expected 2.0, found \"2.1\"",
        "'asset': {'version': '2.0'}, 'extensionsRequired': ['EXT_texture_avif']"
            + " | extensionsRequired: EXT_texture_avif is required; convert its textures to PNG"
            + " or JPEG",
        "'asset': {'version': '2.0'}, 'extensionsRequired': ['ABC_x']"
            + " | extensionsRequired: ABC_x is required; export the model without it"
      })
  void unsupportedFilesAreRefused(String json, String message) {
    check('{' + json.replace('\'', '"') + '}', Kind.UNSUPPORTED, message);
  }

  @Test
  void laterMinorVersionsAreRead() {
    assertThat(refusal("{\"asset\": {\"version\": \"2.7\", \"minVersion\": \"2.0\"}}"))
        .hasMessage("expected at least one triangle with an area, found none");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "'nodes': {} | nodes: expected an array, found an object",
        "'nodes': [3] | nodes[0]: expected an object, found 3",
        "'nodes': [{}, {'mesh': 7}], 'meshes': [{}, {}, {}, {}, {}]"
            + " | nodes[1].mesh: expected 0 to 4, found 7",
        "'nodes': [{'mesh': 0.5}], 'meshes': [{}] | nodes[0].mesh: expected 0 to 0, found 0.5",
        "'nodes': [{'mesh': 'a'}], 'meshes': [{}]"
            + " | nodes[0].mesh: expected a whole number, found \"a\"",
        "'nodes': [{'mesh': 0}]"
            + " | nodes[0].mesh: expected no index into an empty list, found 0",
        "'nodes': [{'children': [1]}, {'children': [0]}]"
            + " | nodes[0]: expected a node that is not below itself, found a cycle",
        "'nodes': [{'children': [0]}]"
            + " | nodes[0]: expected a node that is not below itself, found a cycle",
        "'scenes': [{}], 'scene': 1 | scene: expected 0 to 0, found 1",
        "'nodes': [{'rotation': [0, 0, 0, 0]}]"
            + " | nodes[0].rotation: expected a unit quaternion, found zeros",
        "'nodes': [{'scale': [1, 1]}] | nodes[0].scale: expected 3 numbers, found 2",
        "'nodes': [{'scale': [1, 1, null]}]"
            + " | nodes[0].scale[2]: expected a number, found null",
        "'nodes': [{'matrix': [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,2]}]"
            + " | nodes[0].matrix: expected the last row 0, 0, 0, 1, found another one",
        "'nodes': [{'name': 3}] | nodes[0].name: expected a text, found 3",
        "'nodes': [{'extensions': {'KHR_lights_punctual': {'light': 2}}}],"
            + "'extensions': {'KHR_lights_punctual': {'lights': [{}]}}"
            + " | nodes[0].extensions.KHR_lights_punctual.light: expected 0 to 0, found 2"
      })
  void damagedNodesAreRefused(String json, String message) {
    check('{' + ASSET + ',' + json.replace('\'', '"') + '}', Kind.MALFORMED, message);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "[] | [] | | meshes[0].primitives[0].attributes.POSITION:"
            + " expected no index into an empty list, found 0",
        "[{'componentType': 5126, 'type': 'VEC3', 'count': -1}] | [] |"
            + "| accessors[0].count: expected at least 0, found -1",
        "[{'componentType': 5126, 'type': 'VEC3'}] | [] |"
            + "| accessors[0].count: expected a whole number, found nothing",
        "[{'componentType': 5124, 'type': 'VEC3', 'count': 3}] | [] |"
            + "| accessors[0].componentType: expected 5120 to 5123, 5125 or 5126, found 5124",
        "[{'componentType': 5126, 'type': 'VEC9', 'count': 3}] | [] |"
            + "| accessors[0].type: expected \"SCALAR\", \"VEC2\", \"VEC3\", \"VEC4\", \"MAT2\","
            + " \"MAT3\" or \"MAT4\", found \"VEC9\"",
        "[{'componentType': 5126, 'type': 'VEC2', 'count': 3}] | [] |"
            + "| accessors[0].type: expected 3 numbers per element, found 2",
        "[{'bufferView': 0, 'componentType': 5126, 'type': 'VEC3', 'count': 4}]"
            + " | [{'buffer': 0, 'byteLength': 36}] |"
            + "| accessors[0].bufferView: expected at least 48 bytes, found 36",
        "[{'bufferView': 0, 'byteOffset': 4, 'componentType': 5126, 'type': 'VEC3', 'count': 3}]"
            + " | [{'buffer': 0, 'byteLength': 36}] |"
            + "| accessors[0].bufferView: expected at least 40 bytes, found 36",
        "[{'bufferView': 0, 'byteOffset': 37, 'componentType': 5126, 'type': 'VEC3', 'count': 3}]"
            + " | [{'buffer': 0, 'byteLength': 36}] |"
            + "| accessors[0].byteOffset: expected 0 to 36, found 37",
        "[{'bufferView': 0, 'componentType': 5126, 'type': 'VEC3', 'count': 3}]"
            + " | [{'buffer': 0, 'byteLength': 37}] |"
            + "| bufferViews[0].byteLength: expected 0 to 36, found 37",
        "[{'bufferView': 0, 'componentType': 5126, 'type': 'VEC3', 'count': 3}]"
            + " | [{'buffer': 0, 'byteOffset': 10, 'byteLength': 30}] |"
            + "| bufferViews[0].byteLength: expected 0 to 26, found 30",
        "[{'bufferView': 0, 'componentType': 5126, 'type': 'VEC3', 'count': 3}]"
            + " | [{'buffer': 0, 'byteOffset': 9e15, 'byteLength': 30}] |"
            + "| bufferViews[0].byteOffset: expected 0 to 36, found 9e15",
        "[{'bufferView': 0, 'componentType': 5126, 'type': 'VEC3', 'count': 3}]"
            + " | [{'buffer': 0, 'byteLength': 36, 'byteStride': 8}] |"
            + "| accessors[0].bufferView: expected a byteStride of at least 12, found 8",
        "[{'bufferView': 0, 'componentType': 5126, 'type': 'VEC3', 'count': 3}]"
            + " | [{'buffer': 0, 'byteLength': 36, 'byteStride': 253}] |"
            + "| bufferViews[0].byteStride: expected 1 to 252, found 253",
        "[{'bufferView': 0, 'componentType': 5126, 'type': 'VEC3', 'count': 3}]"
            + " | [{'buffer': 0, 'byteLength': 36}] | 'mode': 7"
            + "| meshes[0].primitives[0].mode: expected 0 to 6, found 7",
        "[{'bufferView': 0, 'componentType': 5126, 'type': 'VEC3', 'count': 3}]"
            + " | [{'buffer': 0, 'byteLength': 36}] | 'indices': 0"
            + "| accessors[0].type: expected 1 numbers per element, found 3",
        "[{'bufferView': 0, 'componentType': 5126, 'type': 'VEC3', 'count': 3},"
            + " {'bufferView': 0, 'componentType': 5126, 'type': 'SCALAR', 'count': 3}]"
            + " | [{'buffer': 0, 'byteLength': 36}] | 'indices': 1"
            + "| accessors[1].componentType: expected 5121, 5123 or 5125 for indices",
        "[{'bufferView': 0, 'componentType': 5126, 'type': 'VEC3', 'count': 3},"
            + " {'bufferView': 0, 'componentType': 5121, 'type': 'SCALAR', 'count': 36}]"
            + " | [{'buffer': 0, 'byteLength': 36}] | 'indices': 1"
            + "| meshes[0].primitives[0].indices: expected vertices from 0 to 2, found 128",
        "[{'bufferView': 0, 'componentType': 5126, 'type': 'VEC3', 'count': 3}]"
            + " | [{'buffer': 0, 'byteLength': 36}] | 'material': 0"
            + "| meshes[0].primitives[0].material: expected no index into an empty list, found 0"
      })
  void damagedMeshesAreRefused(String accessors, String views, String more, String message) {
    String json =
        """
        'accessors': %s, 'bufferViews': %s, 'nodes': [{'mesh': 0}],
        'meshes': [{'primitives': [{'attributes': {'POSITION': 0}%s}]}]
        """
            .formatted(accessors, views, more == null ? "" : "," + more);
    check('{' + ASSET + ',' + TRIANGLE + json.replace('\'', '"') + '}', Kind.MALFORMED, message);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "{'pbrMetallicRoughness': {'baseColorTexture': {}}}"
            + " | materials[0].pbrMetallicRoughness.baseColorTexture.index: expected an index,"
            + " found nothing",
        "{'normalTexture': {'index': 3}}"
            + " | materials[0].normalTexture.index: expected 0 to 1, found 3",
        "{'normalTexture': {'index': 0}} | images[0].bufferView: expected an index, found nothing"
      })
  void damagedMaterialsAreRefused(String material, String message) {
    GltfFile file = new GltfFile();
    file.triangle(", 'material': 0");
    file.add("nodes", "{'mesh': 0}");
    file.add("materials", material);
    file.add("textures", "{'source': 0}");
    file.add("textures", "{'source': 1}");
    file.add("images", "{}");
    file.add("images", "{'uri': 'data:,a'}");
    assertThat(refusal(file.glb(), ModelOptions.DEFAULT)).hasMessage(message);
  }

  @Test
  void countsOfAttributesMustAgree() {
    GltfFile file = new GltfFile();
    int normals = file.floats("VEC3", 0, 0, 1);
    int positions = file.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
    file.meshNode("'POSITION': " + positions + ", 'NORMAL': " + normals, "");
    assertThat(refusal(file.glb(), ModelOptions.DEFAULT))
        .hasMessage(
            "meshes[0].primitives[0].attributes.NORMAL: expected 3 elements, as POSITION has,"
                + " found 1");
  }

  @ParameterizedTest
  @CsvSource({
    "1 0, 'expected increasing numbers from 0 to 2, found 0 at 1'",
    "1 1, 'expected increasing numbers from 0 to 2, found 1 at 1'",
    "0 3, 'expected increasing numbers from 0 to 2, found 3 at 1'"
  })
  void sparseIndicesMustIncrease(String indices, String message) {
    GltfFile file = new GltfFile();
    byte[] places = {
      (byte) (indices.charAt(0) - '0'), (byte) (indices.charAt(2) - '0'),
    };
    file.view(places, "");
    file.view(new byte[24], "");
    file.add(
        "accessors",
        """
        {'componentType': 5126, 'type': 'VEC3', 'count': 3, 'sparse': {'count': 2,
          'indices': {'bufferView': 0, 'componentType': 5121}, 'values': {'bufferView': 1}}}
        """);
    file.meshNode("'POSITION': 0", "");
    assertThat(refusal(file.glb(), ModelOptions.DEFAULT))
        .hasMessage("accessors[0].sparse.indices: " + message);
  }

  @Test
  void jointsMustExist() {
    GltfFile file = new GltfFile();
    int joints = file.bytes(5121, "VEC4", "", 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0);
    int weights = file.floats("VEC4", 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0);
    int positions = file.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
    file.mesh(
        "'POSITION': %d, 'JOINTS_0': %d, 'WEIGHTS_0': %d".formatted(positions, joints, weights),
        "");
    file.add("nodes", "{'mesh': 0, 'skin': 0}");
    file.add("skins", "{'joints': [0]}");
    assertThat(refusal(file.glb(), ModelOptions.DEFAULT))
        .hasMessage(
            "meshes[0].primitives[0].attributes: expected joints from 0 to 0, found 1 at vertex"
                + " 1");
  }

  private static ModelOptions options(Optional<String> animation, Optional<String> variant) {
    return new ModelOptions(
        animation.map(name -> new ModelOptions.Pose(name, 0)), variant, ModelOptions.Up.Y, 1);
  }

  @Test
  void unknownAnimationsAndVariantsAreRefused() {
    GltfFile file = new GltfFile();
    ModelOptions animation = options(Optional.of("run"), Optional.empty());
    ModelOptions variant = options(Optional.empty(), Optional.of("red"));
    assertThat(refusal(file.glb(), animation))
        .hasMessage("animations: expected an animation \"run\", found none in the model");
    assertThat(refusal(file.glb(), variant))
        .hasMessage(
            "extensions.KHR_materials_variants.variants: expected a variant \"red\", found none in"
                + " the model");
    file.add("animations", "{'name': 'walk'}");
    file.add("animations", "{'name': 'fly'}");
    file.set("extensions", "{'KHR_materials_variants': {'variants': [{'name': 'blue'}]}}");
    assertThat(refusal(file.glb(), animation))
        .hasMessage("animations: expected \"walk\" or \"fly\", found \"run\"");
    assertThat(refusal(file.glb(), variant))
        .hasMessage("extensions.KHR_materials_variants.variants: expected \"blue\", found \"red\"");
  }

  @Test
  void keyframesMustIncrease() {
    GltfFile file = GltfFile.ofTriangle();
    int input = file.floats("SCALAR", 0, 1, 1);
    int output = file.floats("VEC3", 0, 0, 0, 0, 0, 0);
    file.add(
        "animations",
        """
        {'channels': [{'sampler': 0, 'target': {'node': 0, 'path': 'scale'}}],
         'samplers': [{'input': %d, 'output': %d}]}
        """
            .formatted(input, output));
    ModelOptions pose = options(Optional.of("0"), Optional.empty());
    assertThat(refusal(file.glb(), pose))
        .hasMessage("accessors[1]: expected increasing times, found 1.0 at 2");
    file.set(
        "animations",
        """
        [{'channels': [{'sampler': 0, 'target': {'node': 0, 'path': 'scale'}}],
         'samplers': [{'input': 0, 'output': 2}]}]
        """);
    assertThat(refusal(file.glb(), pose))
        .hasMessage("accessors[0].type: expected 1 numbers per element, found 3");
    int two = file.floats("SCALAR", 0, 1, 2);
    file.set(
        "animations",
        """
        [{'channels': [{'sampler': 0, 'target': {'node': 0, 'path': 'scale'}}],
         'samplers': [{'input': %d, 'output': 2}]}]
        """
            .formatted(two));
    assertThat(refusal(file.glb(), pose))
        .hasMessage("accessors[2].count: expected 9 numbers, found 6");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "'count': 9e15 | accessors[0].count: expected at most 134217728 elements, found"
            + " 9000000000000000",
        "'count': 16777217 | accessors[0].count: expected at most 16777216 elements without a"
            + " bufferView, found 16777217",
        "'count': 16777216 | accessors[0]: expected at most 100000000 bytes of memory for the"
            + " model"
      })
  void hugeAccessorsAreRefused(String count, String message) {
    GltfFile file = new GltfFile();
    file.add("accessors", "{'componentType': 5126, 'type': 'VEC3', " + count + "}");
    file.meshNode("'POSITION': 0", "");
    ModelFormatException e =
        catchThrowableOfType(
            ModelFormatException.class,
            () ->
                GltfReader.read(
                    file.glb(),
                    GltfFile.EMPTY,
                    ModelOptions.DEFAULT,
                    new GltfBudget(Limits.NONE.withMemory(100_000_000))));
    assertThat(e).hasMessageStartingWith(message);
    assertThat(e.kind()).isEqualTo(Kind.TOO_LARGE);
  }

  @Test
  void deepTreesAreRefused() {
    GltfFile file = new GltfFile();
    for (int i = 0; i < 2000; i++) {
      file.add("nodes", "{'children': [" + (i + 1) + "]}");
    }
    file.add("nodes", "{}");
    ModelFormatException e = refusal(file.glb(), ModelOptions.DEFAULT);
    assertThat(e).hasMessage("nodes[2000]: expected at most 2000 levels, found 2001");
    assertThat(e.kind()).isEqualTo(Kind.TOO_LARGE);
  }

  @Test
  void partsCountAsMemory() {
    GltfFile file = new GltfFile();
    String primitive = "{'attributes': {'POSITION': " + file.floats("VEC3", 0, 0, 0) + "}}";
    file.add("meshes", "{'primitives': [" + (primitive + ",").repeat(39) + primitive + "]}");
    for (int i = 0; i < 20; i++) {
      file.add("nodes", "{'mesh': 0}");
    }
    ModelFormatException e =
        catchThrowableOfType(
            ModelFormatException.class,
            () ->
                GltfReader.read(
                    file.glb(),
                    GltfFile.EMPTY,
                    ModelOptions.DEFAULT,
                    new GltfBudget(Limits.NONE.withMemory(100_000))));
    assertThat(e.kind()).isEqualTo(Kind.TOO_LARGE);
  }

  @Test
  void interruptsStopTheReading() {
    Thread.currentThread().interrupt();
    try {
      assertThatThrownBy(
              () ->
                  ModelReader.read(
                      "a.glb", GltfFile.ofTriangle().glb(), GltfFile.EMPTY, ModelOptions.DEFAULT))
          .isInstanceOf(CancellationException.class)
          .hasMessage("reading was interrupted");
    } finally {
      assertThat(Thread.interrupted()).isTrue();
    }
  }
}
