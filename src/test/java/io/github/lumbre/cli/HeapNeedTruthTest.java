package io.github.lumbre.cli;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.model.internal.HeapNeed;
import java.io.BufferedOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Renders a model with heaps that are larger and smaller than what is said that it takes. */
class HeapNeedTruthTest {
  /** The squares on a side of a wavy surface, of two triangles each. */
  private static final int SIDE = 387;

  private static final int TRIANGLES = 2 * SIDE * SIDE;

  /** The heap that a small model is rendered with. */
  private static final long PROGRAM = 16 << 20;

  @TempDir private Path folder;

  private Path surface() throws IOException {
    Path file = folder.resolve("surface.ply");
    int points = SIDE + 1;
    try (DataOutputStream out =
        new DataOutputStream(new BufferedOutputStream(Files.newOutputStream(file)))) {
      out.write(
          """
          ply
          format binary_big_endian 1.0
          element vertex %d
          property float x
          property float y
          property float z
          element face %d
          property list uchar int vertex_indices
          end_header
          """
              .formatted(points * points, TRIANGLES)
              .getBytes(US_ASCII));
      for (int i = 0; i < points * points; i++) {
        out.writeFloat(i % points);
        out.writeFloat(i / points);
        out.writeFloat((float) Math.sin(.1 * i) * 3);
      }
      for (int i = 0; i < SIDE * SIDE; i++) {
        int corner = i / SIDE * points + i % SIDE;
        for (int middle : new int[] {corner + 1, corner + points}) {
          out.write(3);
          out.writeInt(corner);
          out.writeInt(middle);
          out.writeInt(corner + points + 1);
        }
      }
    }
    return file;
  }

  private Outcome render(Path model, long heap, String progress) throws Exception {
    List<String> command =
        List.of(
            Program.java("java"),
            "-Xmx" + heap,
            "-XX:+UseParallelGC",
            "-cp",
            System.getProperty("java.class.path"),
            Main.class.getName(),
            "render",
            model.toString(),
            "-o",
            folder.resolve("p.png").toString(),
            "--overwrite");
    List<String> small =
        List.of("--size", "32x32", "-s", "1", "--no-denoise", progress);
    Process process =
        new ProcessBuilder(
                Stream.concat(command.stream(), small.stream()).toList())
            .redirectOutput(folder.resolve("out.txt").toFile())
            .redirectError(folder.resolve("err.txt").toFile())
            .start();
    return Program.await(folder, process);
  }

  /** A third less is not enough, and a third more is; the note states the number before. */
  @Test
  void aModelTakesAboutTheHeapThatTheNoteStates() throws Exception {
    Path model = surface();
    long need = HeapNeed.ofTriangles(TRIANGLES).bytes();
    Outcome enough = render(model, PROGRAM + need * 4 / 3, "--progress=none");
    assertThat(enough.exitCode()).as(enough.err()).isZero();
    assertThat(enough.err())
        .startsWith(model + ": " + TRIANGLES + " triangles take about 40 MiB of the heap of ");
    Outcome little = render(model, PROGRAM + need * 2 / 3, "--quiet");
    assertThat(little.exitCode()).isEqualTo(5);
    assertThat(little.err()).doesNotContain("take about");
  }
}
