package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.cli.run.Interruption;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Folders;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** Processes that are stopped after the last sample of a picture, while it is denoised. */
@DisabledOnOs(OS.WINDOWS)
class StoppedStepsTest extends CommandFixture {
  private static final String SMALL = " --size 24x18 -s 2";
  private static final String SLOW = " --oidn T/bin" + SMALL;

  /** Copies the noisy picture; sleeps before it as long as there is a file "wait". */
  private static final String DENOISER =
      """
      #!/bin/sh
      here="$(dirname "$0")"
      echo >> "$here/runs"
      if [ -f "$here/wait" ] && [ "$(wc -l < "$here/runs")" -ge "$(cat "$here/wait")" ]; then
        touch "$here/begun"
        sleep "$(cat "$here/seconds")"
      fi
      for last in "$@"; do
        if [ "$before" = "--hdr" ] || [ "$before" = "--alb" ] || [ "$before" = "--nrm" ]; then
          if [ -z "$from" ]; then from="$last"; fi
        fi
        if [ "$before" = "-o" ]; then to="$last"; fi
        before="$last"
      done
      cp "$from" "$to"
      """;

  private final List<Process> started = new ArrayList<>();

  @BeforeEach
  void writeModelAndDenoiser() throws IOException {
    ModelSample.write(directory);
    Path bin = Files.createDirectory(directory.resolve("bin"));
    Path program = Files.writeString(bin.resolve("oidnDenoise"), DENOISER);
    Files.setPosixFilePermissions(program, PosixFilePermissions.fromString("rwxr-xr-x"));
  }

  @AfterEach
  void endAll() throws InterruptedException {
    Program.endAll(started);
  }

  /**
   * Makes the denoiser sleep.
   *
   * @param run the first run of the program that sleeps, counted from 1; a picture has three
   */
  private void sleep(int run, String seconds) throws IOException {
    for (String name : List.of("runs", "begun")) {
      Files.deleteIfExists(directory.resolve("bin").resolve(name));
    }
    Files.writeString(directory.resolve("bin/seconds"), seconds);
    Files.writeString(directory.resolve("bin/wait"), "" + run);
  }

  private Process start(String line) throws IOException {
    return startClass(Main.class, List.of(Outcome.words(directory, line)));
  }

  private Process startClass(Class<?> main, List<String> arguments) throws IOException {
    List<String> command =
        new ArrayList<>(
            List.of(
                Program.java("java"),
                "-XX:TieredStopAtLevel=1",
                "--add-modules",
                "jdk.incubator.vector",
                "-cp",
                classPath(),
                main.getName()));
    command.addAll(arguments);
    Process process = Program.start(directory, command);
    started.add(process);
    return process;
  }

  private static String classPath() {
    return Stream.of(System.getProperty("java.class.path").split(File.pathSeparator))
        .map(entry -> Path.of(entry).toAbsolutePath().toString())
        .collect(Collectors.joining(File.pathSeparator));
  }

  /** Starts a command, and stops it while the denoiser runs. */
  private Outcome stopped(String name, String line) throws IOException, InterruptedException {
    Process process = start(line);
    while (!Files.exists(directory.resolve("bin/begun"))) {
      assertThat(process.isAlive()).isTrue();
      Thread.sleep(5);
    }
    Program.send(name, process);
    return Program.await(directory, process);
  }

  @Test
  void aPictureThatIsNotDenoisedIsPartial() throws Exception {
    sleep(1, "60");
    Outcome outcome = stopped("TERM", "render T/sample.glb --labels axes --json -o T/a.png" + SLOW);
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.TERMINATED);
    String lack = "2 of 2 samples per pixel, not denoised, without lines and labels";
    assertThat(texts("a.png")).containsEntry("Partial", lack);
    assertThat(outcome.err()).contains("a.png: partial picture of 24x18 pixels, " + lack);
    JsonObject json = outcome.json();
    assertThat(json.get("complete").getAsBoolean()).isFalse();
    assertThat(json.get("exit_code").getAsInt()).isEqualTo(ExitCodes.TERMINATED);
    assertThat(json.get("stopped_by").getAsString()).isEqualTo("signal");
    assertThat(json.getAsJsonArray("missing")).hasSize(2);
  }

  @Test
  void aPictureThatIsSoonDenoisedIsComplete() throws Exception {
    sleep(3, "0.3");
    Outcome outcome = stopped("INT", "render T/sample.glb --json -o T/a.png" + SLOW);
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.INTERRUPTED);
    assertThat(texts("a.png")).doesNotContainKey("Partial").containsKey("Denoised");
    assertThat(outcome.out()).contains("\"complete\":true");
  }

  @Test
  void aFailedDenoiserLeavesAPartialPicture() throws Exception {
    Files.writeString(directory.resolve("bin/oidnDenoise"), "#!/bin/sh\nexit 1\n");
    Outcome outcome = run("render T/sample.glb --json -o T/a.png" + SLOW);
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.OUTPUT);
    assertThat(texts("a.png")).containsEntry("Partial", "2 of 2 samples per pixel, not denoised");
    Outcome views = run("views T/sample.glb -o T/views --oidn T/bin --size 24x18");
    assertThat(views.exitCode()).as(views.err()).isEqualTo(ExitCodes.OUTPUT);
    assertThat(texts("views/front.png"))
        .containsEntry("Partial", "2 of 2 samples per pixel, not denoised");
  }

  @Test
  void framesThatLackAStepAreRenderedAnew() throws Exception {
    String line = "render T/sample.glb --look clay,lines --turntable 3 -o T/";
    assertThat(run(line + "whole.png" + SLOW).exitCode()).isZero();
    sleep(5, "60");
    Outcome outcome = stopped("TERM", line + "a.png" + SLOW);
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.TERMINATED);
    assertThat(outcome.err())
        .contains("stopped after 1 of 3 pictures: ")
        .contains("a-000.png is complete, ", "a-001.png is partial, 1 not rendered: ");
    assertThat(texts("a-001.png").get("Partial")).contains("not denoised, without lines");
    Files.delete(directory.resolve("bin/wait"));
    outcome = run(line + "a.png --continue" + SLOW);
    assertThat(outcome.exitCode()).as(outcome.err()).isZero();
    assertThat(outcome.err()).contains("2 of 3 pictures written, denoised, 1 was complete");
    for (String frame : List.of("-000.png", "-001.png", "-002.png")) {
      assertThat(content(directory.resolve("a" + frame)))
          .isEqualTo(content(directory.resolve("whole" + frame)));
    }
  }

  @Test
  void framesOfOneFileAreJoinedAfterwards() throws Exception {
    String line = "render T/sample.glb T/sample.glb --labels axes -o T/";
    assertThat(run(line + "whole.apng" + SLOW).exitCode()).isZero();
    sleep(2, "60");
    Outcome outcome = stopped("HUP", line + "a.apng" + SLOW);
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.HUNG_UP);
    assertThat(directory.resolve("a.apng")).doesNotExist();
    Files.delete(directory.resolve("bin/wait"));
    outcome = run(line + "a.apng --continue" + SLOW);
    assertThat(outcome.exitCode()).as(outcome.err()).isZero();
    assertThat(directory.resolve("a.apng")).hasSameBinaryContentAs(directory.resolve("whole.apng"));
    assertThat(directory.resolve("a.apng.frames")).doesNotExist();
  }

  @Test
  void stoppedViewsArePartial() throws Exception {
    sleep(5, "60");
    Outcome outcome =
        stopped("TERM", "views T/sample.glb --json -o T/views --oidn T/bin --size 24x18");
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.TERMINATED);
    assertThat(directory.resolve("views").toFile().list())
        .containsExactlyInAnyOrder("front.png", "back.png");
    assertThat(texts("views/front.png")).doesNotContainKey("Partial");
    assertThat(texts("views/back.png").get("Partial")).contains("not denoised");
    assertThat(outcome.err())
        .contains("stopped after 1 of 8 pictures: ")
        .contains("front.png is complete, ", "back.png is partial, 6 not rendered: ");
    JsonObject json = outcome.json();
    assertThat(json.get("exit_code").getAsInt()).isEqualTo(ExitCodes.TERMINATED);
  }

  @Test
  void stoppedDevelopmentsArePartial() throws Exception {
    String film = " --checkpoint T/a.film --layers denoise --no-denoise -o T/a.exr";
    assertThat(Outcome.in(directory, "render T/sample.glb" + film + SMALL).exitCode()).isZero();
    sleep(1, "60");
    Outcome outcome = stopped("TERM", "develop T/a.film --denoise --oidn T/bin -o T/b.png");
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.TERMINATED);
    assertThat(outcome.err()).contains("not denoised, because the render was stopped");
    assertThat(texts("b.png")).containsEntry("Partial", "2 of 2 samples per pixel, not denoised");
  }

  /** Runs two renders in one process, as a list of pictures on Spark does. */
  static final class TwoRenders {
    private TwoRenders() {}

    public static void main(String[] args) {
      Interruption.install();
      for (String name : List.of("a.png", "b.png")) {
        Outcome outcome =
            Outcome.of("render", "sample.glb", "-s", "100000000", "--size", "24x18", "-o", name);
        System.out.println(outcome.err());
      }
      System.exit(Interruption.exitCode(0));
    }
  }

  @Test
  void aSignalEndsLaterRendersOfItsProcess() throws Exception {
    Process process = startClass(TwoRenders.class, List.of());
    while (!Files.exists(directory.resolve(".a.png.tmp"))) {
      assertThat(process.isAlive()).isTrue();
      Thread.sleep(5);
    }
    Program.send("TERM", process);
    Outcome outcome = Program.await(directory, process);
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.TERMINATED);
    assertThat(directory.resolve("b.png")).doesNotExist();
  }

  /** Whenever a sequence is stopped, it is continued to the pictures of one that was not. */
  @Test
  void randomStopsChangeNoPicture() throws Exception {
    Random random = new Random(Effort.seed(461));
    List<String> lines =
        List.of(
            "render T/sample.glb --turntable 3 --look clay,lines --labels all -o T/N/a.png",
            "render T/sample.glb --turntable 3 -o T/N/a.gif",
            "render T/sample.glb T/sample.glb --labels all -o T/N/a.apng",
            "render T/sample.glb --turntable 2 --look clay,lines --denoise -o T/N/a.exr");
    for (int i = 0; i < Effort.count(lines.size(), 40); i++) {
      String line = lines.get(i % lines.size()) + SMALL;
      String whole = line.replace("/N/", "/whole" + i % lines.size() + "/");
      long start = System.nanoTime();
      Process uninterrupted = start(whole);
      assertThat(uninterrupted.waitFor()).isZero();
      long millis = TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - start);
      String stopped = line.replace("/N/", "/stopped" + i + "/");
      Process process = start(stopped);
      process.waitFor(millis * (300 + random.nextInt(700)) / 1000, TimeUnit.MILLISECONDS);
      if (process.isAlive()) {
        Program.send(List.of("TERM", "INT", "HUP").get(random.nextInt(3)), process);
      }
      process.waitFor();
      Outcome outcome = run(stopped + " --continue").done();
      assertThat(contents("stopped" + i)).isEqualTo(contents("whole" + i % lines.size()));
    }
  }

  /** Returns the pixels of all pictures of a folder by their names. */
  private Map<String, String> contents(String folder) throws IOException {
    Map<String, String> all = new TreeMap<>();
    for (Path file : Folders.files(directory.resolve(folder))) {
      all.put("" + file.getFileName(), content(file));
    }
    return all;
  }

  /** Returns the content of a file, and of pictures with the time of their render the pixels. */
  private static String content(Path file) throws IOException {
    byte[] bytes = Files.readAllBytes(file);
    String name = file.toString();
    if (name.endsWith(".png")) {
      bytes = ImageReader.decode(bytes).toPng();
    }
    return name.endsWith(".exr")
        ? Arrays.toString(ImageReader.decodeLinear(bytes).rgb())
        : HexFormat.of().formatHex(bytes);
  }
}
