package io.github.lumbre.model.format.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelReader;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the reading of GLB chunks, files beside the model and data URIs. */
class GltfContainerTest {
  private static final double[] TRIANGLE = {0, 0, 0, 1, 0, 0, 0, 1, 0};

  private static double[] positions(String name, byte[] content, ModelFolder folder)
      throws ModelFormatException, IOException {
    Model model = ModelReader.read(name, content, folder, ModelOptions.DEFAULT);
    return model.parts().get(0).geometry().positions();
  }

  private static String refusal(byte[] content) {
    return catchThrowableOfType(
            ModelFormatException.class, () -> positions("a.glb", content, GltfFile.EMPTY))
        .getMessage();
  }

  @Test
  void binaryChunkIsTheFirstBuffer() throws ModelFormatException, IOException {
    byte[] glb = GltfFile.ofTriangle().glb();
    assertThat(positions("a.GLB", glb, GltfFile.EMPTY)).containsExactly(TRIANGLE);
    assertThat(positions("a.gltf", glb, GltfFile.EMPTY)).containsExactly(TRIANGLE);
  }

  @Test
  void dataUrisAreBuffers() throws ModelFormatException, IOException {
    byte[] gltf = GltfFile.ofTriangle().gltf();
    assertThat(positions("a.gltf", gltf, GltfFile.EMPTY)).containsExactly(TRIANGLE);
  }

  @ParameterizedTest
  @CsvSource({
    "a.bin, a.bin",
    "a%20b.bin, a b.bin",
    "parts/%C3%A4.bin, parts/ä.bin",
    "%2e./a.bin, ../a.bin",
    "a b+c.bin, a b+c.bin"
  })
  void filesAreReadFromTheFolder(String uri, String name) throws ModelFormatException, IOException {
    GltfFile file = GltfFile.ofTriangle();
    List<String> asked = new ArrayList<>();
    ModelFolder folder =
        (found, location) -> {
          asked.add(found + " for " + location);
          return file.buffer();
        };
    assertThat(positions("a.gltf", file.gltf(uri), folder)).containsExactly(TRIANGLE);
    assertThat(asked).containsExactly(name + " for buffers[0].uri");
  }

  @Test
  void unknownChunksAreSkipped() throws ModelFormatException, IOException {
    byte[] glb = GltfFile.ofTriangle().glb();
    ByteBuffer bytes = ByteBuffer.wrap(glb).order(ByteOrder.LITTLE_ENDIAN);
    int json = 20 + bytes.getInt(12);
    ByteBuffer longer = ByteBuffer.allocate(glb.length + 12).order(ByteOrder.LITTLE_ENDIAN);
    longer.put(glb, 0, json).putInt(4).putInt(0x21212121).putInt(0);
    longer.put(glb, json, glb.length - json).putInt(8, longer.capacity());
    assertThat(positions("a.glb", longer.array(), GltfFile.EMPTY)).containsExactly(TRIANGLE);
  }

  @Test
  void bytesAfterTheFileAreIgnored() throws ModelFormatException, IOException {
    byte[] glb = GltfFile.ofTriangle().glb();
    byte[] longer = Arrays.copyOf(glb, glb.length + 9);
    assertThat(positions("a.glb", longer, GltfFile.EMPTY)).containsExactly(TRIANGLE);
  }

  @Test
  void zerosAfterTheJsonAreIgnored() throws ModelFormatException, IOException {
    byte[] json = "{\"asset\": {\"version\": \"2.0\"}}\0\0\0".getBytes(StandardCharsets.US_ASCII);
    byte[] glb = GltfFile.glb(json, new byte[0]);
    assertThat(GltfReader.read(glb, GltfFile.EMPTY, ModelOptions.DEFAULT).parts()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "4  | 1          | byte 4: expected GLB version 2, found 1",
        "4  | -1         | byte 4: expected GLB version 2, found 4294967295",
        "8  | 19         | byte 8: expected the length of the file, 124, found 19",
        "8  | -1         | byte 8: expected the length of the file, 124, found 4294967295",
        "8  | 123        | byte 80: expected a chunk of at most 35 bytes, found 36",
        "12 | 105        | byte 12: expected a chunk of at most 104 bytes, found 105",
        "12 | -1         | byte 12: expected a chunk of at most 104 bytes, found 4294967295",
        "12 | 100        | byte 120: expected a chunk header, found the end of the file",
        "16 | 0          | byte 12: expected a JSON chunk, found another one"
      })
  void damagedHeadersAreRefused(int offset, int value, String message) {
    byte[] json =
        "{\"asset\": {\"version\": \"2.0\"}, \"buffers\": [{\"byteLength\":9}]}"
            .getBytes(StandardCharsets.US_ASCII);
    byte[] glb = GltfFile.glb(json, new byte[36]);
    ByteBuffer.wrap(glb).order(ByteOrder.LITTLE_ENDIAN).putInt(offset, value);
    assertThat(refusal(glb)).isEqualTo(message);
  }

  @ParameterizedTest
  @ValueSource(strings = {"https://example.org/a.bin", "file:///etc/passwd", "//host/a.bin"})
  void urlsAreRefused(String uri) {
    byte[] gltf = GltfFile.ofTriangle().gltf(uri);
    ModelFormatException e =
        catchThrowableOfType(
            ModelFormatException.class, () -> positions("a.gltf", gltf, GltfFile.EMPTY));
    assertThat(e.kind()).isEqualTo(Kind.ASSET);
    assertThat(e)
        .hasMessage(
            "buffers[0].uri: expected a relative path or a data URI, found \"" + uri + "\"");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "data:;base64 | expected a comma in a data URI, found none",
        "data:;base64,AAA*   | expected base64, found other characters",
        "%4.bin | expected two hexadecimal digits after %, found \"%4.bin\"",
        "a%4 | expected two hexadecimal digits after %, found \"a%4\"",
        "a%C3 | expected UTF-8, found \"a%C3\"",
        "'' | expected the name of a file, found nothing"
      })
  void damagedUrisAreRefused(String uri, String message) {
    byte[] gltf = GltfFile.ofTriangle().gltf(uri);
    assertThat(refusal(gltf)).isEqualTo("buffers[0].uri: " + message);
  }

  @Test
  void oneFileIsReadOnce() throws ModelFormatException, IOException {
    GltfFile file = GltfFile.ofTriangle();
    int bytes = file.buffer().length;
    file.set(
        "buffers",
        "[{'byteLength': %1$d, 'uri': 'a'}, {'byteLength': %1$d, 'uri': 'a'}]".formatted(bytes));
    file.add("bufferViews", "{'buffer': 1, 'byteLength': 36}");
    file.add("accessors", "{'bufferView': 1, 'componentType': 5126, 'type': 'VEC3', 'count': 3}");
    file.meshNode("'POSITION': 1", "");
    List<String> asked = new ArrayList<>();
    ModelFolder folder =
        (name, location) -> {
          asked.add(name);
          return file.buffer();
        };
    Model model = ModelReader.read("a.gltf", file.gltf("a"), folder, ModelOptions.DEFAULT);
    assertThat(model.parts().get(1).geometry().positions()).containsExactly(TRIANGLE);
    assertThat(asked).containsExactly("a");
  }

  @Test
  void escapedDataUrisAreBytes() throws ModelFormatException {
    assertThat(GltfUri.data("data:,a%00%ff", "")).containsExactly('a', 0, 255);
  }
}
