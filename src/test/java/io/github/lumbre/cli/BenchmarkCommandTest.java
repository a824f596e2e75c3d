package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.lab.report.ReportTable;
import io.github.lumbre.lab.report.TableHashes;
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

/** Tests the benchmark command, its table and its stored hashes. */
class BenchmarkCommandTest {
  @TempDir private Path directory;

  @BeforeEach
  void writeTable() throws IOException {
    TinyTable.write(directory);
  }

  private Outcome benchmark(String... flags) {
    Stream<String> first = Stream.of("benchmark", "--scenes", directory.toString());
    return Outcome.of(Stream.concat(first, Stream.of(flags)).toArray(String[]::new));
  }

  private static List<String> rows(Outcome outcome) {
    return outcome.out().lines().filter(line -> line.matches("\\| \\d.*")).toList();
  }

  /** Returns the last cell of a row's line. */
  private static String hash(String row) {
    return row.replaceAll(".*`(\\w+)` \\|", "$1");
  }

  @Test
  void rowsAreRenderedAtAHundredthByDefault() {
    Outcome outcome = benchmark("--threads", "1").done();
    assertThat(outcome.err()).isEmpty();
    assertThat(rows(outcome)).hasSize(2);
    assertThat(rows(outcome).get(0)).contains("| First | 16x12 | 3 of 300 | 1 | 8 | 5 |");
    assertThat(rows(outcome).get(1)).contains("| Second | 8x8 | 1 of 4 (ray tracing) | 1 | 32 |");
    assertThat(outcome.out()).contains("1 % of its samples").endsWith("row 4: odd, indeed.\n");
  }

  @Test
  void fullRowsAreNotExtrapolated() {
    Outcome outcome = benchmark("--full", "--warmup", "0");
    assertThat(outcome.out()).contains("| 16x12 | 300 |").doesNotContain("extrapolated");
  }

  @Test
  void rowsAreChosenInTheTablesOrder() {
    assertThat(rows(benchmark("--rows", "4"))).singleElement().asString().contains("Second");
    assertThat(rows(benchmark("--rows", "4,3")))
        .extracting(row -> row.substring(0, 5))
        .containsExactly("| 3 |", "| 4 |");
  }

  @Test
  void hashesDependOnTheSamplesAndNotOnThreadsOrRepetitions() {
    String one = hash(rows(benchmark("--rows", "3", "--threads", "1")).get(0));
    String same = hash(rows(benchmark("--rows", "3", "--threads", "3", "--repeat", "2")).get(0));
    String more = hash(rows(benchmark("--rows", "3", "--scale", "0.02")).get(0));
    assertThat(one).hasSize(16).isEqualTo(same).isNotEqualTo(more);
  }

  @Test
  void storedHashesArePassedAndOthersFail() throws IOException {
    Outcome unknown = benchmark("--check");
    assertThat(unknown.exitCode()).isEqualTo(ExitCodes.DIFFERENT);
    assertThat(unknown.err()).contains("row 3: tiny, 16x12, 3 samples: no hash is stored");
    assertThat(benchmark("--store").exitCode()).isZero();
    assertThat(benchmark("--check"))
        .extracting(Outcome::exitCode, Outcome::err)
        .containsExactly(ExitCodes.OK, "");
    TinyScene.write(directory, TinyScene.with("\"intensity\": 3", "\"intensity\": 2"));
    Outcome changed = benchmark("--check", "--rows", "3");
    assertThat(changed.exitCode()).isEqualTo(ExitCodes.DIFFERENT);
    assertThat(rows(changed)).hasSize(1);
    assertThat(changed.err())
        .startsWith("row 3: tiny, 16x12, 3 samples: the picture differs: expected ")
        .hasLineCount(1);
  }

  @Test
  void storedHashesAreKeptForEachNumberOfSamplesButNotForFormerScenes() throws IOException {
    benchmark("--store", "--rows", "3");
    benchmark("--store", "--scale", "0.02");
    assertThat(stored())
        .extracting(line -> line.substring(0, line.lastIndexOf(',')))
        .containsExactly(
            "row,scene,size,samples", "3,tiny,16x12,3", "3,tiny,16x12,6", "4,tiny,8x8,1");
    Path table = directory.resolve(ReportTable.FILE);
    Files.writeString(table, Files.readString(table).replace("16x12", "12x16"));
    benchmark("--store", "--rows", "3");
    assertThat(stored()).hasSize(3).anyMatch(line -> line.startsWith("3,tiny,12x16,3,"));
  }

  private List<String> stored() throws IOException {
    return Files.readAllLines(directory.resolve(TableHashes.FILE));
  }

  @Test
  void tableIsWrittenForProgramsToo() throws IOException {
    Path file = directory.resolve("out.csv");
    Outcome outcome = benchmark("--csv", file.toString());
    List<String> lines = Files.readAllLines(file);
    assertThat(lines).hasSize(3);
    assertThat(lines.get(0)).startsWith("row,name,scene,size,mode,samples,all_samples,threads");
    assertThat(lines.get(1)).contains(hash(rows(outcome).get(0)));
  }

  @Test
  void resultsBeforeAFailureAreKept() throws IOException {
    Files.writeString(directory.resolve("broken.json"), "{");
    Path table = directory.resolve(ReportTable.FILE);
    Files.writeString(table, Files.readString(table).replace("Second,tiny", "Second,broken"));
    Path file = directory.resolve("out.csv");
    Outcome outcome = benchmark("--csv", file.toString());
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.SCENE);
    assertThat(outcome.err()).contains("broken.json");
    assertThat(rows(outcome)).hasSize(1);
    assertThat(file).content().hasLineCount(2);
  }

  @Test
  void unwritableCsvIsFoundBeforeTheWork() throws IOException {
    Files.writeString(directory.resolve("no"), "");
    benchmark("--csv", directory + "/no/out.csv").assertFailed(ExitCodes.OUTPUT, "no");
  }

  @Test
  void missingScenesAreFoundBeforeTheWork() throws IOException {
    Path table = directory.resolve(ReportTable.FILE);
    Files.writeString(table, Files.readString(table).replace("Second,tiny", "Second,gone"));
    benchmark().assertFailed(ExitCodes.USAGE, "row 4: scene does not exist: ", "gone.json");
    assertThat(benchmark("--rows", "3").exitCode()).isZero();
    Files.delete(table);
    benchmark().assertFailed(ExitCodes.USAGE, "table.csv: does not exist");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--rows 5             | --rows: expected some of 3, 4, found 5",
        "--rows 1-3           | expected an integer up to 2147483647, found '1-3'",
        "--scale half         | expected a number, found 'half'",
        "--scale 0            | --scale: expected more than 0 and at most 1, found 0",
        "--scale 1.01         | found 1.01",
        "--scale 0.1 --full   | mutually exclusive",
        "--check --store      | mutually exclusive",
        "--threads -1         | --threads: expected 0 to 1024, found -1",
        "--warmup -1          | --warmup: expected 0 to 1000, found -1",
        "--repeat 0           | --repeat: expected 1 to 1000, found 0",
      })
  void wrongFlagsAreExplainedInALine(String flags, String message) {
    benchmark(flags.split(" ")).assertFailed(ExitCodes.USAGE, message, "--help");
  }
}
