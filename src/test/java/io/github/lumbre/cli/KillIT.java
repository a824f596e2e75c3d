package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.render.checkpoint.CheckpointFile;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Folders;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Tests renders in their own processes that are killed and resumed. */
@DisabledOnOs(OS.WINDOWS)
class KillIT {
  /** More samples than any of these renders can complete. */
  private static final String ENDLESS = "100000000";

  private static final long MAX_STOP_MILLIS = 2_000;

  private static final int MAX_STOPS = 3;
  private static final long MAX_RENDER_MINUTES = 10;

  @TempDir private Path directory;
  private final List<Process> started = new ArrayList<>();

  @BeforeEach
  void writeScene() {
    TinyScene.write(directory, TinyScene.JSON);
  }

  private Path film() {
    return directory.resolve("a.film");
  }

  private Process start(String... args) throws IOException {
    Process process = Program.start(directory, Program.lumbre(args));
    started.add(process);
    return process;
  }

  /** A failed test must not leave an endless render running. */
  @AfterEach
  void endAll() throws InterruptedException {
    Program.endAll(started);
  }

  private void run(String... args) throws IOException, InterruptedException {
    Process process = start(args);
    // Completing many killed renders may take some time.
    process.waitFor(MAX_RENDER_MINUTES, TimeUnit.MINUTES);
    Outcome outcome = Program.await(directory, process).done();
  }

  private Process startRender() throws IOException {
    return start(
        "render",
        "tiny.json",
        "-s",
        ENDLESS,
        "-o",
        "a.pfm",
        "--checkpoint",
        "a.film",
        "--checkpoint-interval",
        "0.05s");
  }

  private Process startResume() throws IOException {
    return start("resume", "a.film", "--checkpoint-interval", "0.05s", "--threads", "3");
  }

  private void awaitFilm(Process process) throws InterruptedException {
    while (!Files.exists(film())) {
      assertThat(process.isAlive()).isTrue();
      Thread.sleep(1);
    }
  }

  /** Resumes the render to completion and compares the picture with an uninterrupted one. */
  private void assertSamePictureAsUninterrupted() throws IOException, InterruptedException {
    int most = CheckpointFile.load(film()).file().film().mostSamples();
    String samples = String.valueOf(most + 3);
    run("resume", "a.film", "-s", samples, "-o", "resumed.pfm");
    run("render", "tiny.json", "-s", samples, "-o", "whole.pfm");
    assertThat(Files.readAllBytes(directory.resolve("resumed.pfm")))
        .isEqualTo(Files.readAllBytes(directory.resolve("whole.pfm")));
  }

  /** Each render resumes the previous one, which was killed at a random time. */
  @Test
  void killedRendersGoOnToTheSameBits() throws IOException, InterruptedException {
    Random random = new Random(Effort.seed(70));
    Process first = startRender();
    awaitFilm(first);
    killAfter(first, random.nextInt(200));
    long before = 0;
    int kills = Effort.count(3, 120);
    for (int kill = 1; kill < kills; kill++) {
      killAfter(startResume(), 300 + random.nextInt(1_500));
      long samples = CheckpointFile.load(film()).file().film().totalSamples();
      assertThat(samples).isGreaterThanOrEqualTo(before);
      before = samples;
    }
    assertSamePictureAsUninterrupted();
  }

  private static void killAfter(Process process, int millis) throws InterruptedException {
    process.waitFor(millis, TimeUnit.MILLISECONDS);
    process.destroyForcibly();
    process.waitFor();
  }

  @Test
  void terminatedRenderSavesItsFilmInTimeAndGoesOn() throws IOException, InterruptedException {
    assertStopsBy("TERM", ExitCodes.TERMINATED);
  }

  @Test
  void interruptedRenderSavesItsFilmInTimeAndGoesOn() throws IOException, InterruptedException {
    assertStopsBy("INT", ExitCodes.INTERRUPTED);
  }

  /** The quickest of up to three stops counts: other load on the machine can delay any of them. */
  private void assertStopsBy(String signal, int exitCode) throws IOException, InterruptedException {
    long quickest = stopMillis(signal, exitCode);
    for (int i = 1; i < MAX_STOPS && quickest >= MAX_STOP_MILLIS; i++) {
      for (String name : List.of("a.film", "a.film.bak", "a.pfm", "developed.pfm")) {
        Files.delete(directory.resolve(name));
      }
      quickest = Math.min(quickest, stopMillis(signal, exitCode));
    }
    assertThat(quickest).isLessThan(MAX_STOP_MILLIS);
    assertSamePictureAsUninterrupted();
  }

  private long stopMillis(String signal, int exitCode) throws IOException, InterruptedException {
    Process process = startRender();
    awaitFilm(process);
    while (!Files.exists(OutputFile.previous(film()))) {
      Thread.sleep(1);
    }
    long start = System.nanoTime();
    Program.send(signal, process);
    Outcome outcome = Program.await(directory, process);
    long millis = (System.nanoTime() - start) / 1_000_000;
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(exitCode);
    assertThat(outcome.err()).contains("a.pfm: stopped early");
    assertThat(Folders.names(directory))
        .containsExactlyInAnyOrder(
            "a.film", "a.film.bak", "a.pfm", "err.txt", "out.txt", "tiny.json");
    // The film has all samples of the picture.
    run("develop", "a.film", "-o", "developed.pfm");
    assertThat(Files.readAllBytes(directory.resolve("developed.pfm")))
        .isEqualTo(Files.readAllBytes(directory.resolve("a.pfm")));
    return millis;
  }

  /** Saving a film and a picture of this size takes longer than the time between the signals. */
  @Test
  void secondInterruptionLeavesAtOnceAndTheLastFilmIsUsable()
      throws IOException, InterruptedException {
    Process process =
        start(
            "render",
            "tiny.json",
            "-s",
            ENDLESS,
            "--size",
            "1920x1080",
            "--bits",
            "16",
            "-o",
            "a.png",
            "--checkpoint",
            "a.film",
            "--checkpoint-interval",
            "0.05s");
    awaitFilm(process);
    while (process.isAlive()) {
      // If sent before the program handles signals, the second signal is lost.
      new ProcessBuilder("kill", "-INT", "" + process.pid()).start().waitFor();
      process.waitFor(50, TimeUnit.MILLISECONDS);
    }
    Outcome outcome = Program.await(directory, process);
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.INTERRUPTED);
    assertThat(outcome.err()).doesNotContain("stopped early");
    assertThat(directory.resolve("a.png")).doesNotExist();
    assertThat(CheckpointFile.load(film()).file().film().totalSamples()).isPositive();
    run("resume", "a.film", "-s", "2", "-o", "resumed.pfm");
    run("render", "tiny.json", "-s", "2", "--size", "1920x1080", "-o", "whole.pfm");
    assertThat(directory.resolve("resumed.pfm"))
        .hasSameBinaryContentAs(directory.resolve("whole.pfm"));
  }

  /** A deleted directory has the same effect as a full disk. */
  @Test
  void filmThatCannotBeWrittenIsKeptElsewhere() throws IOException, InterruptedException {
    Path lost = Files.createDirectory(directory.resolve("lost"));
    Path elsewhere = Files.createDirectory(directory.resolve("elsewhere"));
    Process process =
        start(
            "render",
            "tiny.json",
            "-s",
            ENDLESS,
            "-o",
            "lost/a.pfm",
            "--checkpoint",
            "lost/a.film",
            "--checkpoint-interval",
            "0.2s",
            "--fallback-dir",
            "elsewhere");
    while (!Files.exists(lost.resolve("a.film"))) {
      assertThat(process.isAlive()).isTrue();
      Thread.sleep(1);
    }
    Files.move(lost, directory.resolve("gone"));
    Thread.sleep(500);
    Program.send("TERM", process);
    Outcome outcome = Program.await(directory, process);
    assertThat(outcome.err())
        .contains("lost/a.film: cannot be written", "lost/a.pfm: cannot be written")
        .contains("the checkpoint is saved as elsewhere/lumbre-", "saved as elsewhere/lumbre-");
    try (Stream<Path> files = Files.list(elsewhere)) {
      List<Path> kept = files.filter(file -> file.toString().endsWith("-a.film")).toList();
      assertThat(kept).hasSize(1);
      assertThat(CheckpointFile.load(kept.get(0)).problem()).isEmpty();
    }
    try (Stream<Path> files = Files.list(elsewhere)) {
      assertThat(files.filter(file -> file.toString().endsWith("-a.pfm"))).hasSize(1);
    }
  }

  @Test
  void twoRendersDoNotShareAFilm() throws IOException, InterruptedException {
    Process first = startRender();
    awaitFilm(first);
    Path other = Files.createDirectory(directory.resolve("other"));
    String film = film().toString();
    Outcome outcome = Program.run(other, Program.lumbre("resume", film, "-o", "b.pfm"));
    first.destroyForcibly().waitFor();
    outcome.assertFailed(ExitCodes.OUTPUT, "a.film: another run is writing this file");
  }
}
