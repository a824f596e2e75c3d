package io.github.lumbre.lab.perf;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.Outcome;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.lab.perf.PerfComparison.Verdict;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the comparison of two measurements. */
class PerfComparisonTest {
  private static final PerfResult BEFORE = PerfFixture.result("tiny", "aa", 1, 1.01, 1.02);

  @TempDir private Path directory;

  private Path file(String name, PerfResult... results) throws IOException {
    return Files.writeString(directory.resolve(name), PerfFixture.TABLES.json(List.of(results)));
  }

  private static Outcome compare(Path first, Path second, String... flags) {
    String[] args = new String[flags.length + 4];
    System.arraycopy(flags, 0, args, 4, flags.length);
    args[0] = "perf";
    args[1] = "--compare";
    args[2] = first.toString();
    args[3] = second.toString();
    return Outcome.of(args);
  }

  private Outcome compare(PerfResult first, PerfResult second) throws IOException {
    return compare(file("a.json", first), file("b.json", second));
  }

  @Test
  void measurementIsNotSlowerThanItself() throws IOException {
    Outcome outcome = compare(BEFORE, BEFORE);
    assertThat(outcome.exitCode()).as(outcome.err()).isZero();
    assertThat(outcome.out())
        .contains("| tiny | 8x4 | 10 | 2 | 1.000 |", "| no difference | same |");
  }

  @Test
  void fasterIsDoneAndSlowerIsNot() throws IOException {
    PerfResult half = PerfFixture.result("tiny", "aa", .5, .51, .52);
    assertThat(compare(BEFORE, half).out()).contains("| 2 | 0.505 | 0.", "| faster | same |");
    assertThat(compare(BEFORE, half).exitCode()).isZero();
    assertThat(compare(half, BEFORE).out()).contains("| slower | same |");
    assertThat(compare(half, BEFORE).exitCode()).isEqualTo(ExitCodes.DIFFERENT);
  }

  @Test
  void otherPicturesAreToldWithTheirReason() throws IOException {
    PerfResult other = PerfFixture.result("tiny", "bb", 1, 1.01, 1.02);
    assertThat(compare(BEFORE, other).out()).contains("| no difference | differ |");
    assertThat(compare(BEFORE, other).exitCode()).isEqualTo(ExitCodes.DIFFERENT);
    Path changed = file("b.json", other);
    Files.writeString(changed, Files.readString(changed).replace("feed", "beef"));
    assertThat(compare(file("a.json", BEFORE), changed).out())
        .contains("| differ, as do the scenes |");
  }

  @Test
  void clockDecides() throws IOException {
    Path a = file("a.json", BEFORE);
    Path b = file("b.json", PerfFixture.result("tiny", "aa", 2, 2.02, 2.04));
    // The same CPU time, twice the wall-clock time.
    String text = Files.readString(b).replace("\"cpu_seconds\": 4.0,", "\"cpu_seconds\": 2.0,");
    text = text.replace("\"cpu_seconds\": 4.04,", "\"cpu_seconds\": 2.02,");
    text = text.replace("\"cpu_seconds\": 4.08,", "\"cpu_seconds\": 2.04,");
    Files.writeString(b, text);
    assertThat(compare(a, b).out()).contains("| 2.000 |", "| 1.000 |", "| no difference |");
    assertThat(compare(a, b, "--by", "wall").out()).contains("| slower |");
  }

  @Test
  void uncountedCpuTimeIsLeftOut() throws IOException {
    Path a = file("a.json", BEFORE);
    Path b = file("b.json", PerfFixture.result("tiny", "aa", 2, 2.02, 2.04));
    Files.writeString(
        a, Files.readString(a).replace("\"cpu_seconds\": 2.0,", "\"cpu_seconds\": 0,"));
    assertThat(compare(a, b).out()).contains("| - | - | slower |");
  }

  @Test
  void workOfOneMeasurementAloneIsNamed() throws IOException {
    Path a = file("a.json", BEFORE, PerfFixture.result("old", "aa", 1, 1));
    Path b = file("b.json", BEFORE, PerfFixture.result("new", "aa", 1, 1));
    assertThat(compare(a, b).out())
        .endsWith(
            "Only in A: old, 8x4, path, 10 samples, 2 threads\n"
                + "Only in B: new, 8x4, path, 10 samples, 2 threads\n");
  }

  @Test
  void nothingInCommonIsAnError() throws IOException {
    Path a = file("a.json", BEFORE);
    compare(a, file("b.json", PerfFixture.result("new", "aa", 1, 1)))
        .assertFailed(ExitCodes.USAGE, "found none");
    compare(a, file("c.json", PerfFixture.result("tiny", "aa", 1)))
        .assertFailed(ExitCodes.USAGE, "repetitions: expected at least 2, found 1");
    compare(a, directory.resolve("no.json")).assertFailed(ExitCodes.USAGE, "no.json: does not");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "{                                | End of input",
        "[]                               | a measurement: expected an object",
        "{}                               | format: expected a string",
        "{'format': 'x'}                  | format: expected lumbre-bench-1, found x",
        "{'format': 'lumbre-bench-1'}     | machine: expected an object",
      })
  void otherFilesAreExplained(String text, String message) throws IOException {
    Path other = Files.writeString(directory.resolve("b.json"), text.replace('\'', '"'));
    Outcome outcome = compare(file("a.json", BEFORE), other);
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.USAGE);
    assertThat(outcome.err())
        .hasLineCount(1)
        .contains("expected a JSON file from 'lumbre perf': ", message);
  }

  @Test
  void timesThatAreNoneAreExplained() throws IOException {
    Path a = file("a.json", BEFORE);
    Path b = file("b.json", BEFORE);
    for (String wrong : List.of("0", "-1", "1e999", "\"1\"", "null", "[]")) {
      Files.writeString(
          b, Files.readString(a).replace("\"seconds\": 1.01,", "\"seconds\": " + wrong + ","));
      compare(a, b).assertFailed(ExitCodes.USAGE, "b.json", "seconds: expected a number");
    }
  }

  @Test
  void onlyWhatIsSureIsCalledADifference() {
    assertThat(verdict(.8, .99)).isEqualTo(Verdict.FASTER);
    assertThat(verdict(1.01, 1.2)).isEqualTo(Verdict.SLOWER);
    assertThat(verdict(.99, 1.2)).isEqualTo(Verdict.NO_DIFFERENCE);
    assertThat(verdict(1, 1)).isEqualTo(Verdict.NO_DIFFERENCE);
  }

  private static Verdict verdict(double low, double high) {
    return Verdict.of(new Interval(Math.sqrt(low * high), low, high));
  }
}
