package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.testing.Folders;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The time limit also applies while a scene is read. */
class ReadingTimeoutTest {
  private static final int TRIANGLES = 2_000_000;

  /**
   * The maximum processor time of the reading thread, in seconds; the whole scene takes several
   * times as long.
   */
  private static final double MOST_SECONDS = 1;

  @TempDir private Path directory;

  /** Reading the mesh and building its hierarchy takes several times as long as the limit. */
  @Test
  void timeoutEndsReading() throws IOException {
    String mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + "f 1 2 3\n".repeat(TRIANGLES);
    Files.writeString(directory.resolve("large.obj"), mesh);
    Path scene =
        TinyScene.write(
            directory,
            TinyScene.withAsset("{\"id\": 9, \"assetType\": \"Mesh\", \"file\": \"large.obj\"}")
                .replace(
                    "\"objects\": [",
                    "\"objects\": [{\"type\": \"Shape\", \"shapeType\": \"Mesh\","
                        + " \"meshId\": 9, \"materialID\": 1},"));
    String picture = directory.resolve("a.png").toString();
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    long start = threads.getCurrentThreadCpuTime();
    Outcome outcome =
        Outcome.of("render", scene.toString(), "-o", picture, "--timeout", "0.3s", "-s", "1");
    double seconds = (threads.getCurrentThreadCpuTime() - start) * 1e-9;
    outcome.assertFailed(
        ExitCodes.LIMIT, "--timeout", "before anything was rendered; no picture is written");
    assertThat(seconds).isLessThan(MOST_SECONDS);
    assertThat(Thread.currentThread().isInterrupted()).isFalse();
    assertThat(Folders.names(directory)).containsExactlyInAnyOrder("large.obj", "tiny.json");
  }
}
