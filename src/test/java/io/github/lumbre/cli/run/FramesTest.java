package io.github.lumbre.cli.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.output.Fallback;
import io.github.lumbre.cli.output.JsonSummary;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Tests the end of a sequence of pictures, with a simulated clock. */
class FramesTest {
  private static final int COUNT = 4;

  @TempDir private Path directory;

  private final AtomicLong nanos = new AtomicLong();
  private final Interruption interruption = Interruption.listen();
  private final Deadline deadline = Deadline.after(Optional.of(Duration.ofNanos(1)), nanos::get);

  @AfterEach
  void stopListening() {
    interruption.close();
  }

  private Frames frames(int count) throws TaskException {
    List<Path> targets = Frames.numbered(directory.resolve("a.png"), count);
    Frames frames = new Frames(targets, interruption, deadline);
    frames.reserve(Fallback.TEMPORARY);
    return frames;
  }

  private interface Event {
    void happen() throws TaskException;
  }

  /** Renders a frame during which something happens. */
  private ExitCode render(Frames frames, boolean complete, Event event) throws Exception {
    JsonSummary report = new JsonSummary("render", Path.of("a.glb"));
    return new Run(interruption, Optional.empty(), Optional.of(frames))
        .of(
            report,
            () -> {
              event.happen();
              report.put("complete", complete);
              return ExitCode.OK;
            });
  }

  private Frames after(int complete) throws Exception {
    Frames frames = frames(COUNT);
    for (int i = 0; i < complete; i++) {
      render(frames, true, () -> {});
    }
    return frames;
  }

  private void assertEnds(
      ExitCode code, String message, Frames frames, boolean complete, Event event) {
    assertThatThrownBy(() -> render(frames, complete, event))
        .isInstanceOfSatisfying(TaskException.class, e -> assertThat(e.code()).isEqualTo(code))
        .hasMessage(message.replace("a-", directory.resolve("a-").toString()));
  }

  @Test
  void placesStateTheTimeThatIsLeftOnceAFrameIsComplete() throws Exception {
    long start = System.nanoTime();
    Frames frames = after(0);
    assertThat(frames.place()).isEqualTo("1/4");
    assertThat(frames.placeValues()).containsOnly(Map.entry("frame", 1), Map.entry("frames", 4));
    TimeUnit.MILLISECONDS.sleep(50);
    render(frames, true, () -> {});
    double left = frames.placeValues().get("seconds_left_in_all").doubleValue();
    // One of four frames is complete.
    assertThat(left).isBetween(3 * .05, 3e-9 * (System.nanoTime() - start));
    assertThat(frames.place()).matches("2/4, all in 0:0[0-9]:[0-9]{2}");
    assertThat(frames.placeValues().keySet())
        .containsExactly("frame", "frames", "seconds_left_in_all");
  }

  @Test
  void signalsEndTheSequenceAndNameTheCompleteFrames() throws Exception {
    assertEnds(
        ExitCode.INTERRUPTED,
        "stopped after 1 of 4 pictures: a-000.png is complete, a-001.png is partial,"
            + " 2 not rendered: a-002.png to a-003.png",
        after(1),
        false,
        interruption::request);
  }

  @Test
  void signalsBetweenTwoFramesEndIt() throws Exception {
    assertEnds(
        ExitCode.INTERRUPTED,
        "stopped after 3 of 4 pictures: a-000.png to a-002.png are complete, 1 not"
            + " rendered: a-003.png",
        after(2),
        true,
        interruption::request);
  }

  @Test
  void signalsInTheLastFrameNameItOnlyIfItIsPartial() throws Exception {
    assertEnds(
        ExitCode.INTERRUPTED,
        "stopped after 3 of 4 pictures: a-000.png to a-002.png are complete, a-003.png is partial",
        after(3),
        false,
        interruption::request);
  }

  @Test
  void signalsAtTheVeryEndChangeNothing() throws Exception {
    assertThat(render(after(3), true, interruption::request)).isEqualTo(ExitCode.OK);
  }

  @Test
  void signalsAfterAFrameDoNotWaitForTheNextOne() throws Exception {
    Frames frames = frames(COUNT);
    assertThat(render(frames, true, interruption::requireRender)).isEqualTo(ExitCode.OK);
    assertThat(interruption.request()).isFalse();
  }

  @Test
  void signalsDuringReadingNameTheFrames() throws Exception {
    assertEnds(
        ExitCode.INTERRUPTED,
        "stopped after 2 of 4 pictures: a-000.png to a-001.png are complete, 2 not rendered:"
            + " a-002.png to a-003.png",
        after(2),
        false,
        () -> {
          throw new TaskException(ExitCode.INTERRUPTED, "stopped before anything was rendered");
        });
  }

  @Test
  void passedDeadlinesEndItBeforeTheNextFrame() throws Exception {
    assertEnds(
        ExitCode.LIMIT,
        "--timeout: the time ended after 2 of 4 pictures: a-000.png to a-001.png are complete,"
            + " a-002.png is partial, 1 not rendered: a-003.png",
        after(2),
        false,
        () -> nanos.set(1));
  }

  @Test
  void deadlinesInTheLastFrameLeaveItPartial() throws Exception {
    Frames frames = after(3);
    assertThat(render(frames, false, () -> nanos.set(1))).isEqualTo(ExitCode.OK);
    assertThat(frames.summary())
        .isEqualTo("3 of 4 pictures written, " + frames.target() + " is partial");
  }

  @Test
  void otherLimitsKeepTheirMessage() throws Exception {
    assertThatThrownBy(
            () ->
                render(
                    after(1),
                    false,
                    () -> {
                      throw new TaskException(ExitCode.LIMIT, "too large");
                    }))
        .hasMessage("too large");
  }

  @Test
  void failedFramesAreNamedAtTheEnd() throws Exception {
    Frames frames = after(2);
    assertThat(frames.title()).isEqualTo("3/4 a-002.png");
    frames.fail(Path.of("c.glb"));
    assertThat(frames.left()).isEqualTo(1);
    assertEnds(
        ExitCode.INTERRUPTED,
        "stopped after 2 of 4 pictures: 1 not rendered: a-003.png, 1 failed: c.glb",
        frames,
        false,
        () -> {
          throw new TaskException(ExitCode.INTERRUPTED, "stopped before anything was rendered");
        });
    assertThat(frames.haveEnded()).isTrue();
  }

  @Test
  void onlyTheFirstFailuresAreNamed() throws Exception {
    Frames frames = frames(23);
    for (int i = 0; i < 22; i++) {
      frames.fail(Path.of(i + ".glb"));
    }
    render(frames, true, () -> {});
    assertThat(frames.summary())
        .startsWith("1 of 23 pictures written, 22 failed: 0.glb, 1.glb, ")
        .endsWith(", 19.glb and 2 more");
  }

  @Test
  void singlePicturesAreNoSequence() throws Exception {
    assertThat(render(frames(1), false, interruption::request)).isEqualTo(ExitCode.OK);
  }

  @Test
  void allFilesAreReservedByOneLockAtTheBeginning() throws Exception {
    try (Frames frames = frames(COUNT)) {
      assertThat(frames.targets()).hasSize(COUNT);
      assertThat(directory.toFile().list()).hasSize(1);
      assertThatThrownBy(() -> frames(COUNT)).hasMessageContaining("another run is writing");
      List<Path> later = Frames.numbered(directory.resolve("a.png"), 9).subList(3, 9);
      Frames others = new Frames(later, interruption, deadline);
      assertThatThrownBy(() -> others.reserve(Fallback.TEMPORARY))
          .hasMessageContaining("a-003.png: another run is writing this file");
      try (Frames free = new Frames(later.subList(1, 6), interruption, deadline)) {
        free.reserve(Fallback.TEMPORARY);
      }
      assertThatThrownBy(() -> frames(COUNT)).hasMessageContaining("another run is writing");
    }
    assertThat(directory).isEmptyDirectory();
  }

  /** Linux counts the open files of this process in this folder. */
  @Test
  @EnabledOnOs(OS.LINUX)
  void manyFramesNeedFewOpenFiles() throws Exception {
    File open = new File("/proc/self/fd");
    int before = open.list().length;
    try (Frames frames = frames(2_000)) {
      assertThat(frames.left()).isEqualTo(2_000);
      assertThat(open.list().length - before).isLessThan(50);
    }
    assertThat(directory).isEmptyDirectory();
  }

  @Test
  void framesThatCannotBeWrittenAreNamedAtTheBeginning() throws Exception {
    Files.createDirectory(directory.resolve("a-002.png"));
    assertThatThrownBy(() -> frames(COUNT)).hasMessageContaining("a-002.png: is a directory");
    assertThat(directory.toFile().list()).containsExactly("a-002.png");
  }
}
