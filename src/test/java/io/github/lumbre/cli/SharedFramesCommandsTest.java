package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.cli.run.Engine;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Denoised frames of a sequence depend on the frames around them, and on nothing else. */
class SharedFramesCommandsTest extends CommandFixture {
  private static final String SMALL = " --size 24x18 -s 4";
  private static final String LIFT = "render T/sample.glb --animation lift --fps 9 --view front";
  private static final String TURN = "render T/sample.glb --turntable 9 --ground";

  @BeforeEach
  void writeModel() throws IOException {
    ModelSample.write(directory);
  }

  private void assertSame(String one, String other, int... frames) throws IOException {
    for (int frame : frames) {
      assertThat(pixels(other + "-00" + frame + ".png"))
          .as("frame " + frame)
          .isEqualTo(pixels(one + "-00" + frame + ".png"));
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {LIFT, TURN})
  void partsHaveTheBitsOfTheWhole(String line) throws IOException {
    assertThat(said(line + " -o T/a.png --threads 2" + SMALL))
        .contains("9 of 9 pictures written, denoised: a-000.png");
    String[] parts = {"0..0", "2..4", "8"};
    for (String part : parts) {
      assertThat(said(line + " -o T/b.png --threads 1 --frames " + part + SMALL))
          .contains(
              "written, denoised, %d neighbors rendered again".formatted(neighbors(line, part)));
    }
    assertSame("a", "b", 0, 2, 3, 4, 8);
    assertThat(texts("b-000.png"))
        .containsEntry("DenoisedWith", line.equals(TURN) ? "6 neighbors" : "3 neighbors");
    assertThat(texts("b-003.png")).containsEntry("DenoisedWith", "6 neighbors");
  }

  /** Returns how many neighbors frames of a part have outside it. */
  private static int neighbors(String line, String part) {
    return line.equals(TURN) ? 6 : part.equals("2..4") ? 5 : 3;
  }

  @Test
  void neighborsChangeFramesThatMove() throws IOException {
    runs(TURN + " -o T/a.png" + SMALL);
    runs("render T/sample.glb --turntable 1 --ground -o T/b.png" + SMALL);
    assertThat(pixels("a-000.png")).isNotEqualTo(pixels("b-000.png"));
    runs(TURN + " --no-denoise -o T/a.png --overwrite" + SMALL);
    runs("render T/sample.glb --turntable 1 --ground --no-denoise -o T/b.png --overwrite" + SMALL);
    assertThat(pixels("a-000.png")).isEqualTo(pixels("b-000.png"));
  }

  @Test
  void whatStandsStillIsThePictureAlone() throws IOException {
    ModelSample.writeWith(directory, "\"path\": \"translation\"}}", "\"path\": \"scale\"}}");
    runs("render T/sample.glb --pose lift@0 -o T/alone.png" + SMALL);
    String line = "render T/sample.glb --animation lift --fps 2 -o T/a.png --frames ";
    runs(line + "0..1" + SMALL);
    assertThat(pixels("a-000.png")).isNotEqualTo(pixels("a-001.png"));
    ModelSample.writeWith(directory, "\"node\": 0, \"path\"", "\"node\": 1, \"path\"");
    runs("render T/sample.glb --camera 1 --pose lift@0 -o T/alone.png --overwrite" + SMALL);
    runs(line + "0..1 --overwrite --camera 1" + SMALL);
    assertThat(pixels("a-000.png")).isEqualTo(pixels("alone.png")).isEqualTo(pixels("a-001.png"));
  }

  /** Frames that lack samples of a neighbor are not written, and are rendered later. */
  @Test
  void stoppedFramesAreContinued() throws IOException {
    run(LIFT + " -o T/a.png --size 24x18 -s 100000000 --timeout 2s")
        .assertFailed(ExitCodes.LIMIT, "--timeout: the time ended after 0 of 9 pictures");
    assertThat(directory.resolve("a-000.png")).doesNotExist();
    runs(LIFT + " -o T/b.png" + SMALL);
    runs(LIFT + " -o T/a.png --continue --frames 0..5" + SMALL);
    Files.delete(directory.resolve("a-003.png"));
    assertThat(said(LIFT + " -o T/a.png --continue" + SMALL))
        .contains("4 of 9 pictures written, denoised, 5 neighbors rendered again, 5 were complete");
    assertSame("b", "a", 0, 1, 2, 3, 4, 5, 6, 7, 8);
  }

  /** Frames that an earlier version denoised alone are no neighbors of others. */
  @Test
  void framesOfOtherNeighborsAreRefused() throws IOException {
    String line = "render T/sample.glb -o T/a.png --size 24x18 -s 2 ";
    runs(line + "--turntable 2");
    Files.delete(directory.resolve("a-001.png"));
    run(line + "--turntable 3 --continue")
        .assertFailed(
            ExitCodes.USAGE,
            "a-000.png: cannot be continued: its metadata have DenoisedWith 0 neighbors,"
                + " expected 2");
  }

  /** A cluster gets the scene of each frame once. */
  @Test
  void enginesGetEachFrameOnce() {
    AtomicInteger scenes = new AtomicInteger();
    Engine engine =
        (path, scene, local, isTimed) -> {
          scenes.incrementAndGet();
          return local;
        };
    String line = TURN + " -o T/a.png" + SMALL;
    String[] args = line.replace("T/", directory + "/").split(" ");
    PrintWriter none = new PrintWriter(Writer.nullWriter());
    assertThat(Lumbre.run(args, none, none, engine)).isZero();
    assertThat(directory.resolve("a-008.png")).exists();
    assertThat(scenes).hasValue(9);
  }

  @Test
  void estimatesStateTheMemoryOfTheWindow() throws IOException {
    Outcome outcome = run("render T/sample.glb --turntable 9 --dry-run --size 640x480");
    assertThat(outcome.out()).contains("window   203 MiB more for frames that are denoised");
    assertThat(run("render T/sample.glb --dry-run --size 640x480").out()).doesNotContain("window");
  }
}
