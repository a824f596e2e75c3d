package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonElement;
import com.google.gson.JsonParser;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.lab.report.ReportTable;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests {@code lumbre perf}. */
class PerfCommandTest {
  @TempDir private Path directory;

  private Path scene;

  @BeforeEach
  void writeScene() {
    scene = TinyScene.write(directory, TinyScene.JSON);
  }

  private Outcome bench(String... flags) {
    Stream<String> first = Stream.of("perf", scene.toString());
    return Outcome.of(Stream.concat(first, Stream.of(flags)).toArray(String[]::new));
  }

  private static List<String> rows(Outcome outcome) {
    return outcome.out().lines().filter(line -> line.startsWith("| tiny")).toList();
  }

  /** Returns the last cell of a row's line. */
  private static String hash(String row) {
    return row.replaceAll(".*`(\\w+)` \\|", "$1");
  }

  @Test
  void everyNumberOfThreadsHasItsRowOfTheSamePicture() {
    Outcome outcome = bench("--threads", "1,3,1", "-s", "2", "--repeat", "2").done();
    assertThat(outcome.err()).isEmpty();
    assertThat(rows(outcome)).hasSize(2);
    assertThat(rows(outcome).get(0)).startsWith("| tiny | 16x12 | 2 | 1 | ");
    assertThat(rows(outcome).get(1)).startsWith("| tiny | 16x12 | 2 | 3 | ");
    assertThat(hash(rows(outcome).get(0))).hasSize(16).isEqualTo(hash(rows(outcome).get(1)));
  }

  @Test
  void pictureIsThatOfRender() throws IOException {
    Path json = directory.resolve("out.json");
    bench("--threads", "1", "-s", "2", "--size", "8x6", "--json", json.toString());
    Path table = TinyTable.write(directory).resolve(ReportTable.FILE);
    Files.writeString(table, Files.readString(table).replace("16x12,path,300,8", "8x6,path,2,8"));
    Outcome other =
        Outcome.of("benchmark", "--scenes", directory.toString(), "--rows", "3", "--full");
    String line =
        other.out().lines().filter(row -> row.startsWith("| 3")).findFirst().orElseThrow();
    assertThat(json).content().contains("\"image_sha256\": \"" + hash(line));
  }

  @Test
  void noiseIsThatOfOtherSeedsAndFallsWithSamples() throws IOException {
    List<Double> few = relativeMses("-s", "1");
    List<Double> many = relativeMses("-s", "64");
    assertThat(few).hasSize(2).doesNotHaveDuplicates();
    // With independent samples, it would be 64 times lower.
    assertThat(many).hasSize(2).allMatch(error -> error > 0 && error < few.get(0) / 32);
  }

  private List<Double> relativeMses(String... flags) throws IOException {
    Path json = directory.resolve("out.json");
    Stream<String> first = Stream.of("--threads", "1", "--warmup", "0", "--json", json.toString());
    bench(Stream.concat(first, Stream.of(flags)).toArray(String[]::new));
    return JsonParser.parseString(Files.readString(json))
        .getAsJsonObject()
        .getAsJsonArray("results")
        .get(0)
        .getAsJsonObject()
        .getAsJsonArray("relative_mse")
        .asList()
        .stream()
        .map(JsonElement::getAsDouble)
        .toList();
  }

  @Test
  void largeFramesAreShrunk() {
    TinyScene.write(directory, TinyScene.with("16, \"height\": 12", "1600, \"height\": 900"));
    Outcome outcome = bench("--threads", "0", "-s", "1", "--repeat", "1", "--warmup", "1");
    assertThat(rows(outcome)).singleElement().asString().startsWith("| tiny | 320x180 | 1 |");
  }

  @Test
  void resultsBeforeAFailureAreKept() throws IOException {
    Path broken = Files.writeString(directory.resolve("broken.json"), "{");
    Path json = directory.resolve("out.json");
    Outcome outcome =
        bench(broken.toString(), "--threads", "1", "-s", "1", "--json", json.toString());
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.SCENE);
    assertThat(rows(outcome)).hasSize(1);
    assertThat(json).content().contains("\"scene\": \"tiny\"");
  }

  @Test
  void unwritableFileIsFoundBeforeTheWork() throws IOException {
    Files.writeString(directory.resolve("no"), "");
    bench("--json", directory + "/no/out.json").assertFailed(ExitCodes.OUTPUT, "no");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "gone.json            | scene does not exist: gone.json",
        "-s 0                 | --samples: expected 1 to 1073741824, found 0",
        "--size 0x4           | --size: expected 1 to 65535, found 0",
        "--size 4x70000       | --size: expected 1 to 65535, found 70000",
        "--threads 1,-1       | --threads: expected 0 to 1024, found -1",
        "--warmup -1          | --warmup: expected 0 to 1000, found -1",
        "--repeat 0           | --repeat: expected 1 to 1000, found 0",
        "--pairs 0            | --pairs: expected 1 to 1000, found 0",
      })
  void wrongFlagsAreExplainedInALine(String flags, String message) {
    bench(flags.split(" ")).assertFailed(ExitCodes.USAGE, message, "--help");
  }

  @Test
  void nothingToMeasureIsAnError() {
    Outcome.of("perf").assertFailed(ExitCodes.USAGE, "SCENE", "--help");
  }

  @Test
  void scenesOfOneNameAreRefused() {
    bench(scene.toString()).assertFailed(ExitCodes.USAGE, "different names, found two named tiny");
  }

  @Test
  void pairsTellWhatAShortcutSaves() {
    Outcome outcome =
        bench("--paired", "--without", "ONE_EMITTER", "--repeat", "12", "-s", "1", "--threads", "1")
            .done();
    assertThat(rows(outcome)).hasSize(1);
    assertThat(rows(outcome).get(0)).startsWith("| tiny | 16x12 | 1 | ").endsWith("| same |");
  }

  @Test
  void pairsTellWhatAdaptiveSamplingBrings() {
    Outcome outcome = bench("--paired", "--adaptive", "-s", "128").done();
    assertThat(rows(outcome).get(0)).contains("| 16x12 | 128 | ").endsWith("| different |");
    bench("--paired", "--adaptive", "--json", "a.json")
        .assertFailed(ExitCodes.USAGE, "--paired: cannot be combined with --json");
    bench("--paired", "--adaptive", "--repeat", "11")
        .assertFailed(ExitCodes.USAGE, "--repeat: expected 12 to ");
    bench("--paired")
        .assertFailed(ExitCodes.USAGE, "--paired: requires --without, --adaptive or --split");
  }

  @Test
  void pairsTellWhatSplitPathsBring() {
    Outcome outcome = bench("--paired", "--split", "3", "-s", "2").done();
    assertThat(outcome.out()).contains("Paths split into 3.");
    assertThat(rows(outcome).get(0)).contains("| 16x12 | 2 | ").endsWith("| different |");
    bench("--split", "0").assertFailed(ExitCodes.USAGE, "--split: expected 1 to 256, found 0");
  }
}
