package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.render.checkpoint.CheckpointFile;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Folders;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the launcher in a terminal: the progress bar, Ctrl-C, Ctrl-Z and a closed window. */
class TerminalIT {
  /** More samples than any of these renders can complete. */
  private static final String ENDLESS = "100000000";

  private static final Pattern BAR =
      Pattern.compile(
          " *(\\d+) % \\[=*>? *\\] \\d:\\d\\d:\\d\\d left, [0-9.]+( M)? samples/s"
              + "(, noise [0-9.]+ % \\(target 0.0010 %\\))?");

  /** The text of a progress bar as soon as there are samples. */
  private static final Pattern BEGUN = Pattern.compile(" [1-9][0-9.]*( M)? samples/s");

  private static final long MAX_STOP_SECONDS = 10;

  @TempDir private Path home;
  @TempDir private Path directory;

  @BeforeEach
  void makeProject() throws IOException, InterruptedException {
    boolean isNeeded = "true".equals(System.getenv("CI"));
    assumeTrue(
        isNeeded || PseudoTerminal.isSupported(),
        "TerminalIT is skipped: this system has no 'script' of util-linux to make a terminal with");
    Program.copyOptions(home);
    Files.writeString(home.resolve("pom.xml"), "");
    Files.copy(Path.of("lumbre"), home.resolve("lumbre"));
    assertThat(home.resolve("lumbre").toFile().setExecutable(true)).isTrue();
    Program.copyJars(home);
    TinyScene.write(directory, TinyScene.JSON);
  }

  private PseudoTerminal run(int columns, String command) throws IOException, InterruptedException {
    return PseudoTerminal.run(
        directory,
        columns,
        Map.of(
            "JAVA_HOME", System.getProperty("java.home"),
            // The renders are short: the second JIT compiler would cost more time than it saves.
            "LUMBRE_JAVA_OPTS", "-Xmx512m -XX:TieredStopAtLevel=1",
            "LUMBRE", home.resolve("lumbre").toString()),
        command);
  }

  /** Runs the launcher instead of the terminal's shell. */
  private PseudoTerminal lumbre(int columns, String arguments)
      throws IOException, InterruptedException {
    return run(columns, "echo $$ >pid.new; mv pid.new pid.txt; exec \"$LUMBRE\" " + arguments);
  }

  private static void awaitBar(PseudoTerminal terminal) throws InterruptedException {
    terminal.await("a bar", printed -> BEGUN.matcher(printed).find());
  }

  private void assertNothingLeftBehind() throws IOException {
    assertThat(Folders.names(directory)).noneMatch(name -> name.startsWith("."));
  }

  private void signal(String name) throws IOException, InterruptedException {
    String pid = Files.readString(directory.resolve("pid.txt")).strip();
    assertThat(new ProcessBuilder("kill", "-" + name, pid).start().waitFor()).isZero();
  }

  @Test
  void barMovesEverySecondAndLeavesOneCleanLine() throws IOException, InterruptedException {
    try (PseudoTerminal terminal =
        lumbre(120, "render tiny.json -o a.png --timeout 10s --target-error 0.001%")) {
      awaitBar(terminal);
      long start = System.nanoTime();
      assertThat(terminal.exitCode()).isEqualTo(ExitCodes.TARGET);
      double seconds = (System.nanoTime() - start) * 1e-9;
      List<String> bars = terminal.bars(0).stream().filter(bar -> !bar.contains(" ... ")).toList();
      assertThat(bars.size()).as(terminal.printed()).isGreaterThan((int) seconds);
      assertThat(bars).allMatch(bar -> BAR.matcher(bar).matches());
      assertThat(bars).anyMatch(bar -> bar.contains("noise"));
      List<Integer> percents = bars.stream().map(TerminalIT::percent).toList();
      assertThat(percents).isSorted();
      assertThat(percents.get(percents.size() - 1) - percents.get(0)).isGreaterThan(30);
      List<String> screen = terminal.screen();
      assertThat(screen).noneMatch(line -> line.contains(" left"));
      assertThat(screen).filteredOn(line -> line.startsWith("a.png: ")).hasSize(1);
    }
    assertNothingLeftBehind();
  }

  private static int percent(String bar) {
    Matcher matcher = BAR.matcher(bar);
    assertThat(matcher.matches()).as(bar).isTrue();
    return Integer.parseInt(matcher.group(1));
  }

  @Test
  void barFollowsTheWidthOfTheWindow() throws IOException, InterruptedException {
    try (PseudoTerminal terminal = lumbre(120, "render tiny.json -s " + ENDLESS + " -o a.png")) {
      awaitBar(terminal);
      terminal.await("a wide bar", p -> terminal.bars(0).stream().anyMatch(b -> b.length() > 70));
      for (int columns : new int[] {40, 20, 100}) {
        int from = terminal.length();
        terminal.resize(columns);
        terminal.await(
            "a bar of " + columns + " columns",
            p -> lastBar(terminal, from) > columns / 2 && lastBar(terminal, from) < columns);
      }
      terminal.control('C');
      assertThat(terminal.exitCode()).isEqualTo(ExitCodes.INTERRUPTED);
    }
  }

  private static int lastBar(PseudoTerminal terminal, int from) {
    List<String> bars = terminal.bars(from);
    return bars.isEmpty() ? 0 : bars.get(bars.size() - 1).length();
  }

  /** Presses Ctrl-C before or while a large mesh is read and its hierarchy is built. */
  @Test
  void interruptedReadingLeavesNothing() throws IOException, InterruptedException {
    writeLargeScene();
    Random random = new Random(Effort.seed(201));
    for (int i = 0; i < Effort.count(3, 30); i++) {
      try (PseudoTerminal terminal = lumbre(80, "render large.json -s " + ENDLESS + " -o a.png")) {
        // Reading takes about as long as the start of Java, building twice as long.
        int millis = random.nextInt(4000);
        terminal.await(
            "its beginning", p -> Files.exists(directory.resolve(".a.png.tmp")) || p.length() > 0);
        awaitMillis(terminal, millis);
        assertInterrupted(terminal);
      }
    }
  }

  /** Commands that read a model; the keys are pressed while it is read or soon after. */
  @ParameterizedTest
  @ValueSource(strings = {"views large.obj --size 64x48 -o .", "view large.obj --no-open"})
  void interruptedReadingOfAModelEnds(String command) throws IOException, InterruptedException {
    writeLargeScene();
    Random random = new Random(Effort.seed(204));
    for (int i = 0; i < Effort.count(2, 20); i++) {
      try (PseudoTerminal terminal = lumbre(120, command)) {
        awaitMillis(terminal, 500 + random.nextInt(2000));
        terminal.control('C');
        assertThat(terminal.exitCode()).as(terminal.printed()).isEqualTo(ExitCodes.INTERRUPTED);
        assertThat(terminal.printed()).doesNotContain("internal error");
      }
      assertNothingLeftBehind();
    }
  }

  private static void awaitMillis(PseudoTerminal terminal, int millis) throws InterruptedException {
    long start = System.nanoTime();
    terminal.await("a moment", p -> System.nanoTime() - start > 1_000_000L * millis);
  }

  private void assertInterrupted(PseudoTerminal terminal) throws IOException, InterruptedException {
    boolean hasRendered = BEGUN.matcher(terminal.printed()).find();
    long start = System.nanoTime();
    terminal.control('C');
    assertThat(terminal.exitCode()).as(terminal.printed()).isEqualTo(ExitCodes.INTERRUPTED);
    assertThat(TimeUnit.NANOSECONDS.toSeconds(System.nanoTime() - start))
        .isLessThan(MAX_STOP_SECONDS);
    // The terminal prints ^C, which may precede the summary.
    List<String> screen =
        terminal.screen().stream().map(line -> line.replaceFirst("^\\^C", "")).toList();
    boolean isSaved = screen.stream().anyMatch(line -> line.startsWith("a.png: "));
    assertThat(isSaved).as(terminal.printed()).isEqualTo(Files.exists(directory.resolve("a.png")));
    assertThat(isSaved || !hasRendered).as(terminal.printed()).isTrue();
    assertThat(screen).noneMatch(line -> line.endsWith("samples/s") && line.contains(" left"));
    if (!isSaved) {
      assertThat(String.join("\n", screen))
          .contains("stopped before anything was rendered; no picture is written");
    }
    assertNothingLeftBehind();
    Files.deleteIfExists(directory.resolve("a.png"));
  }

  /** Writes a mesh of many triangles, which takes longer to read than to render. */
  private void writeLargeScene() throws IOException {
    int side = 300;
    StringBuilder obj = new StringBuilder();
    for (int y = 0; y < side; y++) {
      for (int x = 0; x < side; x++) {
        obj.append("v ").append(x * .01).append(' ').append(Math.sin(x * y)).append(' ');
        obj.append(y * .01).append('\n');
      }
    }
    for (int y = 1; y < side; y++) {
      for (int x = 1; x < side; x++) {
        int v = y * side + x + 1;
        obj.append("f ").append(v).append(' ').append(v - 1).append(' ').append(v - side - 1);
        obj.append(' ').append(v - side).append('\n');
      }
    }
    Files.writeString(directory.resolve("large.obj"), obj);
    Files.writeString(
        directory.resolve("large.json"),
        TinyScene.withAsset("{\"id\": 9, \"assetType\": \"Mesh\", \"file\": \"large.obj\"}")
            .replace(
                "\"objects\": [",
                "\"objects\": [{\"id\": 9, \"type\": \"Shape\", \"shapeType\": \"Mesh\","
                    + " \"meshId\": 9, \"materialID\": 1},"));
  }

  /** Each render resumes the previous one, which was interrupted. */
  @Test
  void interruptedRendersAndResumesSavePictureAndFilm() throws IOException, InterruptedException {
    Random random = new Random(Effort.seed(202));
    String flags = " -o a.png --checkpoint-interval 0.05s";
    long before = 0;
    for (int i = 0; i < Effort.count(4, 40); i++) {
      String command =
          i == 0
              ? "render tiny.json -s " + ENDLESS + " --checkpoint a.film" + flags
              : "resume a.film" + flags;
      try (PseudoTerminal terminal = lumbre(80, command)) {
        awaitBar(terminal);
        awaitMillis(terminal, random.nextInt(500));
        assertInterrupted(terminal);
      }
      CheckpointFile.Loaded loaded = CheckpointFile.load(directory.resolve("a.film"));
      assertThat(loaded.problem()).isEmpty();
      assertThat(loaded.file().film().totalSamples()).isGreaterThan(before);
      before = loaded.file().film().totalSamples();
    }
  }

  /** With this number of pixels, the first pass takes longer than pressing the key. */
  @Test
  void interruptedFirstPassTellsTheShareOfBlackPixels() throws IOException, InterruptedException {
    try (PseudoTerminal terminal =
        lumbre(100, "render tiny.json -s 1 --split 16 --size 2000x1500 -o a.png")) {
      awaitBar(terminal);
      assertInterrupted(terminal);
      assertThat(terminal.screen())
          .anyMatch(
              line ->
                  line.matches(
                      ".*warning: [1-9]\\d* % of the pixels have no sample and are black"));
    }
  }

  private PseudoTerminal writingLargePicture() throws IOException, InterruptedException {
    PseudoTerminal terminal =
        lumbre(80, "render tiny.json -s 1 --size 1000x700 --bits 16 -o a.png");
    Path temporary = directory.resolve(".a.png.tmp");
    terminal.await(
        "the beginning of the picture",
        p -> temporary.toFile().length() > 0 || Files.exists(directory.resolve("a.png")));
    return terminal;
  }

  @Test
  void interruptedWritingIsCompleted() throws IOException, InterruptedException {
    Random random = new Random(Effort.seed(203));
    for (int i = 0; i < Effort.count(3, 20); i++) {
      try (PseudoTerminal terminal = writingLargePicture()) {
        awaitMillis(terminal, random.nextInt(200));
        assertInterrupted(terminal);
      }
    }
  }

  @Test
  void secondInterruptEndsAtOnce() throws IOException, InterruptedException {
    // Encoding this picture takes many times longer than the time between the two signals.
    String large = "render tiny.json -s " + ENDLESS + " --size 2000x1500 --bits 16 -o a.png";
    try (PseudoTerminal terminal = lumbre(80, large)) {
      awaitBar(terminal);
      terminal.control('C');
      Thread.sleep(20);
      long start = System.nanoTime();
      terminal.control('C');
      assertThat(terminal.exitCode()).isEqualTo(ExitCodes.INTERRUPTED);
      assertThat(TimeUnit.NANOSECONDS.toSeconds(System.nanoTime() - start))
          .isLessThan(MAX_STOP_SECONDS);
      assertThat(terminal.printed()).doesNotContain("a.png: ");
    }
    assertThat(directory.resolve("a.png")).doesNotExist();
    assertNothingLeftBehind();
  }

  @Test
  void terminationSavesThePicture() throws IOException, InterruptedException {
    try (PseudoTerminal terminal = lumbre(80, "render tiny.json -s " + ENDLESS + " -o a.png")) {
      awaitBar(terminal);
      signal("TERM");
      assertThat(terminal.exitCode()).isEqualTo(ExitCodes.TERMINATED);
      assertThat(String.join("\n", terminal.screen())).contains("a.png: stopped early");
    }
    assertThat(directory.resolve("a.png")).exists();
    assertNothingLeftBehind();
  }

  @ParameterizedTest
  @CsvSource({"INT, 130", "TERM, 143", "HUP, 129"})
  void signalsEndATurntableAfterThePartialFrame(String name, int code)
      throws IOException, InterruptedException {
    ModelSample.write(directory);
    String frames = " --turntable 3 --no-denoise --size 64x48 -s " + ENDLESS + " -o a.png";
    try (PseudoTerminal terminal = lumbre(200, "render sample.glb" + frames)) {
      awaitBar(terminal);
      signal(name);
      assertThat(terminal.exitCode()).as(terminal.printed()).isEqualTo(code);
      assertThat(terminal.screen())
          .contains(
              "lumbre: stopped after 0 of 3 pictures: a-000.png is partial,"
                  + " 2 not rendered: a-001.png to a-002.png");
    }
    assertThat(directory.resolve("a-000.png")).exists();
    assertThat(directory.resolve("a-001.png")).doesNotExist();
    assertNothingLeftBehind();
  }

  /** A frame that is denoised with its neighbors is not written before they are rendered. */
  @Test
  void controlCLeavesNoFrameWithoutItsNeighbors() throws IOException, InterruptedException {
    ModelSample.write(directory);
    String frames = " --turntable 3 --size 64x48 -o a.gif -s ";
    try (PseudoTerminal terminal = lumbre(200, "render sample.glb" + frames + ENDLESS)) {
      awaitBar(terminal);
      terminal.control('C');
      assertThat(terminal.exitCode()).as(terminal.printed()).isEqualTo(ExitCodes.INTERRUPTED);
      assertThat(terminal.screen())
          .contains(
              "lumbre: stopped after 0 of 3 pictures: 3 not rendered: a.gif.frames/a-000.png to"
                  + " a.gif.frames/a-002.png; the same command with --continue goes on");
    }
    assertThat(directory.resolve("a.gif.frames")).doesNotExist();
    assertNothingLeftBehind();
  }

  @Test
  void controlCKeepsTheFramesOfAnAnimation() throws IOException, InterruptedException {
    ModelSample.write(directory);
    String frames = " --animation lift --no-denoise --fps 3 --size 64x48 -o a.gif -s ";
    try (PseudoTerminal terminal = lumbre(200, "render sample.glb" + frames + ENDLESS)) {
      terminal.await("a bar", printed -> printed.contains("1/3:   0 % ["));
      terminal.control('C');
      assertThat(terminal.exitCode()).as(terminal.printed()).isEqualTo(ExitCodes.INTERRUPTED);
      assertThat(terminal.screen())
          .contains(
              "lumbre: stopped after 0 of 3 pictures: a.gif.frames/a-000.png is partial, 2 not"
                  + " rendered: a.gif.frames/a-001.png to a.gif.frames/a-002.png; the same command"
                  + " with --continue goes on");
    }
    assertThat(directory.resolve("a.gif")).doesNotExist();
    assertThat(directory.resolve("a.gif.frames").toFile().list()).containsExactly("a-000.png");
    assertNothingLeftBehind();
  }

  @Test
  void controlCEndsABatchAfterThePartialPicture() throws IOException, InterruptedException {
    Files.copy(directory.resolve("tiny.json"), directory.resolve("b.json"));
    Files.writeString(directory.resolve("broken.glb"), "glTF and no more");
    String scenes = "render broken.glb tiny.json b.json -o out -s " + ENDLESS;
    try (PseudoTerminal terminal = lumbre(200, scenes)) {
      terminal.await("a bar", printed -> printed.contains("2/3 tiny.png:   0 % ["));
      terminal.control('C');
      assertThat(terminal.exitCode()).as(terminal.printed()).isEqualTo(ExitCodes.INTERRUPTED);
      assertThat(terminal.screen())
          .contains(
              "lumbre: stopped after 0 of 3 pictures: out/tiny.png is partial, 1 not rendered:"
                  + " out/b.png, 1 failed: broken.glb");
    }
    assertThat(directory.resolve("out/tiny.png")).exists();
    assertThat(directory.resolve("out").toFile().list()).containsExactly("tiny.png");
    assertNothingLeftBehind();
  }

  /** Like an interactive shell, the shell here forwards the signal and waits. */
  @Test
  void closedWindowSavesThePicture() throws IOException, InterruptedException {
    String arguments = "render tiny.json -s " + ENDLESS + " -o a.png --checkpoint a.film";
    try (PseudoTerminal terminal =
        run(
            80,
            "trap 'kill -HUP $!' HUP; \"$LUMBRE\" "
                + arguments
                + " & wait $!; wait $!; echo $? >code.new; mv code.new code.txt")) {
      awaitBar(terminal);
      terminal.closeWindow();
      Path code = directory.resolve("code.txt");
      long start = System.nanoTime();
      while (!Files.exists(code)) {
        assertThat(System.nanoTime() - start).isLessThan(TimeUnit.SECONDS.toNanos(30));
        Thread.sleep(5);
      }
      assertThat(Files.readString(code).strip()).isEqualTo(String.valueOf(ExitCodes.HUNG_UP));
    }
    assertThat(directory.resolve("a.png")).exists();
    assertThat(CheckpointFile.load(directory.resolve("a.film")).problem()).isEmpty();
    assertNothingLeftBehind();
  }

  @Test
  void otherCommandsEndAtOnceAndLeaveNothing() throws IOException, InterruptedException {
    try (PseudoTerminal terminal = lumbre(80, "trade tiny.json --quick -o trade.html")) {
      terminal.await("its beginning", printed -> printed.contains("reference"));
      assertEndsPromptly(terminal);
    }
    assertThat(directory.resolve("trade.html")).doesNotExist();
  }

  private void assertEndsPromptly(PseudoTerminal terminal)
      throws IOException, InterruptedException {
    long start = System.nanoTime();
    terminal.control('C');
    assertThat(terminal.exitCode()).as(terminal.printed()).isEqualTo(ExitCodes.INTERRUPTED);
    assertThat(TimeUnit.NANOSECONDS.toSeconds(System.nanoTime() - start))
        .isLessThan(MAX_STOP_SECONDS);
    assertThat(terminal.screen()).noneMatch(line -> line.contains(" left"));
    assertNothingLeftBehind();
  }

  @Test
  void suspendedRenderGoesOnInTheForeground() throws IOException, InterruptedException {
    try (PseudoTerminal terminal = run(80, "PS1='> ' exec sh -i")) {
      terminal.type("\"$LUMBRE\" render tiny.json -s " + ENDLESS + " -o a.png\n");
      awaitBar(terminal);
      terminal.control('Z');
      terminal.await("a stopped job", printed -> printed.contains("Stopped"));
      int stopped = terminal.length();
      Thread.sleep(1000);
      assertThat(terminal.bars(stopped)).isEmpty();
      terminal.type("fg\n");
      terminal.await("a bar", printed -> terminal.bars(stopped).size() > 2);
      terminal.control('C');
      terminal.await("a picture", printed -> printed.contains("a.png: stopped early"));
      terminal.type("echo code=$?\n");
      terminal.await("the code", printed -> printed.contains("code=" + ExitCodes.INTERRUPTED));
      terminal.type("exit\n");
      terminal.exitCode();
    }
    assertNothingLeftBehind();
  }
}
