package io.github.lumbre.model.internal;

import static io.github.lumbre.model.ModelFolder.NONE;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.Models;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.StagedModel;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CancellationException;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests what is refused before memory is allocated for it. */
class ModelLimitsTest {
  /** A million triangles were rendered with a heap of 155 MiB, and not with one of 146 MiB. */
  @Test
  void modelsThatCannotFitIntoTheHeapAreRefused() {
    HeapNeed triangles = HeapNeed.ofTriangles(1_000_000);
    assertThatCode(() -> ModelLimits.requireHeap("", triangles, 155L << 20))
        .doesNotThrowAnyException();
    assertThatThrownBy(() -> ModelLimits.requireHeap("element face", triangles, 100L << 20))
        .isInstanceOf(ModelFormatException.class)
        .hasMessage(
            "element face: expected a model that fits into the heap of 100 MiB, found 1000000"
                + " triangles, which take 134 MiB or more; Java's option -Xmx sets the heap");
  }

  private static void write(Path file, String start, long size) throws IOException {
    try (RandomAccessFile sparse = new RandomAccessFile(file.toFile(), "rw")) {
      sparse.write(start.getBytes(StandardCharsets.US_ASCII));
      sparse.setLength(size);
    }
  }

  @Test
  void filesThatNoArrayHoldsAreRefused(@TempDir Path folder) throws IOException {
    Path ply = folder.resolve("a.ply");
    write(ply, "ply\nformat binary_little_endian 1.0\n", 1L << 31);
    assertThatThrownBy(() -> Models.read(ply))
        .isInstanceOf(ModelFormatException.class)
        .hasMessage("expected at most 2147483639 bytes, found 2147483648");
    Path gltf = folder.resolve("a.gltf");
    Files.writeString(
        gltf,
        """
        {"asset": {"version": "2.0"}, "buffers": [{"uri": "a.ply", "byteLength": 36}],
         "bufferViews": [{"buffer": 0, "byteLength": 36}],
         "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
          "min": [0, 0, 0], "max": [1, 1, 0]}],
         "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "nodes": [{"mesh": 0}]}
        """);
    assertThatThrownBy(() -> Models.read(gltf))
        .hasMessageContaining("\"a.ply\": expected at most 2147483639 bytes, found more");
  }

  @Test
  void limitsHoldForAllFilesOfAModel(@TempDir Path folder) throws IOException {
    Path obj = folder.resolve("a.obj");
    Files.writeString(obj, "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    Files.writeString(folder.resolve("a.mtl"), "newmtl a\n" + "#".repeat(100));
    assertThatThrownBy(() -> Models.read(obj, limited(40)))
        .hasMessage("expected at most 40 bytes, found 45");
    assertThatThrownBy(() -> Models.read(obj, limited(60)))
        .hasMessage("line 1: \"a.mtl\": expected at most 60 bytes, found more");
    assertThatCode(() -> Models.read(obj, limited(200))).doesNotThrowAnyException();
  }

  private static ModelOptions limited(long bytes) {
    return ModelOptions.DEFAULT.limitedTo(Limits.NONE.withBytes(bytes));
  }

  @Test
  void anInterruptCancelsReading(@TempDir Path folder) throws IOException {
    byte[] obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".getBytes(StandardCharsets.US_ASCII);
    Path file = Files.write(folder.resolve("a.obj"), obj);
    List<ThrowingCallable> readings =
        List.of(
            () -> Models.read(file),
            () -> Models.read("a.obj", obj),
            () -> StagedModel.read(file, Stage.DEFAULT, new SceneParser()),
            () -> StagedModel.read("a.obj", obj, NONE, Stage.DEFAULT, new SceneParser()));
    for (ThrowingCallable reading : readings) {
      Thread.currentThread().interrupt();
      assertThatThrownBy(reading).isInstanceOf(CancellationException.class);
      assertThat(Thread.interrupted()).isTrue();
    }
  }

  /** A million points were rendered with a heap of 320 MiB, and not with one of 280 MiB. */
  @Test
  void pointsThatCannotFitIntoTheHeapAreRefused() {
    HeapNeed points = HeapNeed.ofPoints(1_000_000);
    assertThatCode(() -> ModelLimits.requireHeap("", points, 320L << 20))
        .doesNotThrowAnyException();
    assertThatThrownBy(() -> ModelLimits.requireHeap("element vertex", points, 200L << 20))
        .hasMessage(
            "element vertex: expected a model that fits into the heap of 200 MiB, found 1000000"
                + " points, which take 258 MiB or more; Java's option -Xmx sets the heap");
  }
}
