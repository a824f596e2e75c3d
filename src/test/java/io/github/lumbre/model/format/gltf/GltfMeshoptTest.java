package io.github.lumbre.model.format.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.format.meshopt.MeshoptSamples;
import io.github.lumbre.model.format.meshopt.MeshoptSamples.Sample;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelGeometry;
import java.io.IOException;
import java.util.Arrays;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Compressed buffer views of glTF files are read as others are. */
class GltfMeshoptTest {
  private static final String KHR = "KHR_meshopt_compression";
  private static final String EXT = "EXT_meshopt_compression";
  private static final String PLACE = "bufferViews[2].extensions.EXT_meshopt_compression";

  /** Positions of 100 vertices, whose numbers are sin(i / 50) (1 + i % 3). */
  private static final Sample POSITIONS = MeshoptSamples.of("floats-v1-3");

  /** Triangles of a grid of 10 × 10 vertices. */
  private static final Sample TRIANGLES = MeshoptSamples.of("grid-triangles-2");

  private static final byte[] DAMAGED = {0};

  /** A file with one compressed mesh of 162 triangles and 100 vertices. Mutable. */
  private static final class Compressed {
    private final GltfFile file = new GltfFile();
    private final String name;

    /** What the buffer view of the positions states. */
    private String positions =
        "'byteStride': 12, 'count': 100, 'mode': 'ATTRIBUTES', 'filter': 'NONE'";

    private byte[] stream = POSITIONS.stream();
    private int length = 1200;
    private String plain = "'buffer': 1";
    private String fallback = "{'byteLength': 2000}";

    private Compressed(String name) {
      this.name = name;
    }

    private int view(String layout, byte[] bytes, int decoded, String uncompressed) {
      int offset = file.buffer().length;
      file.view(bytes, "");
      return file.add(
          "bufferViews",
          "{%s, 'byteLength': %d, 'extensions': {'%s': {%s, %s, %s, %s}}}"
              .formatted(
                  uncompressed,
                  decoded,
                  name,
                  "'buffer': 0",
                  "'byteOffset': " + offset,
                  "'byteLength': " + bytes.length,
                  layout));
    }

    /** Adds the mesh; a plain triangle is stored before it. */
    private GltfFile build() {
      file.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
      String accessor = "{'bufferView': %d, 'componentType': %d, 'type': '%s', 'count': %d}";
      int view = view(positions, stream, length, plain);
      int position = file.add("accessors", accessor.formatted(view, 5126, "VEC3", length / 12));
      String layout = "'byteStride': 2, 'count': 486, 'mode': 'TRIANGLES'";
      view = view(layout, TRIANGLES.stream(), 972, "'buffer': 1");
      int indices = file.add("accessors", accessor.formatted(view, 5123, "SCALAR", 486));
      file.meshNode("'POSITION': " + position, length == 1200 ? ", 'indices': " + indices : "");
      file.set("buffers", "[{'byteLength': %d}, %s]".formatted(file.buffer().length, fallback));
      return file.set("extensionsUsed", "['" + name + "']");
    }

    private GltfFile required() {
      return build().set("extensionsRequired", "['" + name + "']");
    }

    private Compressed damaged() {
      stream = DAMAGED;
      return this;
    }

    /** Makes the mesh a triangle whose plain positions are in the file. */
    private Compressed triangle() {
      positions = "'byteStride': 12, 'count': 3, 'mode': 'ATTRIBUTES'";
      length = 36;
      plain = "'buffer': 0";
      return damaged();
    }
  }

  private static String refusal(GltfFile file) {
    ModelFormatException e = catchThrowableOfType(ModelFormatException.class, file::read);
    return e.kind() + " " + e.getMessage();
  }

  @ParameterizedTest
  @ValueSource(strings = {KHR, EXT})
  void meshesAreDecoded(String name) throws ModelFormatException, IOException {
    GltfFile file = new Compressed(name).required();
    ModelGeometry mesh = file.geometry();
    assertThat(mesh.triangleCount()).isEqualTo(162);
    assertThat(mesh.vertexCount()).isEqualTo(100);
    for (int i = 0; i < 300; i++) {
      assertThat(mesh.positions()[i]).isEqualTo((float) (Math.sin(i / 50.0) * (1 + i % 3)));
    }
    assertThat(Arrays.stream(mesh.indices()).distinct().count()).isEqualTo(100);
    assertThat(file.read().warnings()).isEmpty();
  }

  @Test
  void animationsAreDecoded() throws ModelFormatException, IOException {
    GltfFile file = GltfFile.ofTriangle();
    Sample sample = MeshoptSamples.of("exponential-23-v0");
    int input = file.floats("SCALAR", IntStream.range(0, 20).asDoubleStream().toArray());
    int offset = file.buffer().length;
    file.view(sample.stream(), "");
    int view =
        file.add(
            "bufferViews",
            """
            {'buffer': 1, 'byteLength': 240, 'extensions': {'KHR_meshopt_compression': {
              'buffer': 0, 'byteOffset': %d, 'byteLength': %d, 'byteStride': 12, 'count': 20,
              'mode': 'ATTRIBUTES', 'filter': 'EXPONENTIAL'}}}\
            """
                .formatted(offset, sample.stream().length));
    int output =
        file.add(
            "accessors",
            "{'bufferView': " + view + ", 'componentType': 5126, 'type': 'VEC3', 'count': 20}");
    file.add(
        "animations",
        """
        {'samplers': [{'input': %d, 'output': %d}],
          'channels': [{'sampler': 0, 'target': {'node': 0, 'path': 'translation'}}]}\
        """
            .formatted(input, output));
    int length = file.buffer().length;
    file.set("buffers", "[{'byteLength': " + length + "}, {'byteLength': 240}]");
    Optional<ModelOptions.Pose> pose = Optional.of(new ModelOptions.Pose("0", 7));
    Model model = file.read(new ModelOptions(pose, Optional.empty(), ModelOptions.Up.Y, 1));
    double x = model.parts().get(0).toWorld().point(Vec3.ZERO).x();
    assertThat(x).isCloseTo(Math.sin(3 * 7 / 50.0), within(1e-6));
  }

  @Test
  void plainBytesAreNotReadUnlessNeeded() throws ModelFormatException, IOException {
    Compressed compressed = new Compressed(EXT);
    compressed.fallback = "{'byteLength': 2000, 'uri': 'missing.bin'}";
    GltfFile file = compressed.build();
    assertThat(file.geometry().triangleCount()).isEqualTo(162);
    assertThat(file.read().warnings()).isEmpty();
  }

  @Test
  void plainBytesReplaceDamagedData() throws ModelFormatException, IOException {
    GltfFile file = new Compressed(EXT).triangle().build();
    assertThat(file.geometry().positions()).containsExactly(0, 0, 0, 1, 0, 0, 0, 1, 0);
    String reason = PLACE + ": byte 1 of its meshopt data: expected 0xa0 or 0xa1 (version 0 or 1)";
    assertThat(file.read().warnings())
        .containsExactly(reason + " at byte 0, found 0x00; the uncompressed data is used");
    assertThat(refusal(new Compressed(EXT).triangle().required()))
        .isEqualTo("UNSUPPORTED " + reason + " at byte 0, found 0x00");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "{'byteLength': 2000}",
        "{'byteLength': 2000, 'extensions': {'EXT_meshopt_compression': {'fallback': true}}}"
      })
  void damagedDataWithoutPlainBytesIsRefused(String fallback) {
    Compressed compressed = new Compressed(EXT).damaged();
    compressed.fallback = fallback;
    assertThat(refusal(compressed.build())).startsWith("UNSUPPORTED " + PLACE + ": byte ");
  }

  @Test
  void buffersWithoutBytesNeedCompressedViews() {
    GltfFile file = new GltfFile();
    file.view(DAMAGED, "");
    file.add("bufferViews", "{'buffer': 1, 'byteLength': 36}");
    file.add("accessors", "{'bufferView': 1, 'componentType': 5126, 'type': 'VEC3', 'count': 3}");
    file.meshNode("'POSITION': 0", "");
    file.set(
        "buffers",
        "[{'byteLength': 4}, {'byteLength': 36, 'extensions': {'"
            + KHR
            + "': {'fallback': true}}}]");
    assertThat(refusal(file)).startsWith("MALFORMED buffers[1].uri: expected a URI, ");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "'count': 100 | 'count': 99 | bufferViews[2].byteLength: expected 99 times 12 bytes,"
            + " found 1200",
        "'count': 100 | 'count': 300000000 | PLACE.count: expected 0 to 134217728,"
            + " found 300000000",
        "'byteStride': 12 | 'byteStride': 10 | PLACE.byteStride: expected a size of ATTRIBUTES"
            + " with the filter NONE, found 10",
        "'byteStride': 12 | 'byteStride': 260 | PLACE.byteStride: expected 2 to 256, found 260",
        "NONE | QUATERNION | PLACE.byteStride: expected a size of ATTRIBUTES with the filter"
            + " QUATERNION, found 12",
        "NONE | CUBIC | PLACE.filter: expected \"NONE\", \"OCTAHEDRAL\", \"QUATERNION\","
            + " \"EXPONENTIAL\" or \"COLOR\", found \"CUBIC\"",
        "ATTRIBUTES | POINTS | PLACE.mode: expected \"ATTRIBUTES\", \"TRIANGLES\" or \"INDICES\","
            + " found \"POINTS\"",
        "ATTRIBUTES', 'filter': 'NONE | INDICES', 'filter': 'COLOR | PLACE.filter: expected NONE"
            + " with the mode INDICES, found \"COLOR\"",
        "12, 'count': 100, 'mode': 'ATTRIBUTES | 4, 'count': 400, 'mode': 'TRIANGLES"
            + " | PLACE.count: expected a multiple of 3, found 400"
      })
  void viewsMustFit(String original, String changed, String message) {
    Compressed compressed = new Compressed(EXT);
    compressed.positions = compressed.positions.replace(original, changed);
    assertThat(refusal(compressed.required()))
        .isEqualTo("MALFORMED " + message.replace("PLACE", PLACE));
  }

  @Test
  void memoryIsLimited() {
    Compressed compressed = new Compressed(EXT).triangle();
    compressed.positions = compressed.positions.replace("'count': 3", "'count': 400000");
    compressed.length = 4_800_000;
    compressed.stream = new byte[5000];
    byte[] file = compressed.build().glb();
    GltfBudget budget = new GltfBudget(Limits.NONE.withMemory(1_000_000));
    ModelFormatException e =
        catchThrowableOfType(
            ModelFormatException.class,
            () -> GltfReader.read(file, GltfFile.EMPTY, ModelOptions.DEFAULT, budget));
    assertThat(e.kind()).isEqualTo(Kind.TOO_LARGE);
    assertThat(e).hasMessageStartingWith(PLACE + ": expected at most 1000000 bytes of memory");
  }

  @Test
  void mutantsAreReadOrRefused() throws IOException {
    GltfMutationTest.checkMutants(new Compressed(KHR).build().glb(), 0, 1000);
  }

  @Test
  @Tag("fuzz")
  void manyMutantsAreReadOrRefused() throws IOException {
    long seed = Long.getLong("lumbre.fuzz.seed", System.nanoTime());
    GltfMutationTest.checkMutants(new Compressed(KHR).build().glb(), seed, 100_000);
  }
}
