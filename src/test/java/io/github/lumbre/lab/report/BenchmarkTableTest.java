package io.github.lumbre.lab.report;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.base.Release;
import io.github.lumbre.lab.Csv;
import io.github.lumbre.lab.metrics.Interval;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests the two output formats of a benchmark. */
class BenchmarkTableTest {
  private static BenchmarkTables tables(String share) {
    return new BenchmarkTables(BenchmarkFixture.MACHINE, BenchmarkFixture.plan(share));
  }

  @Test
  void captionTellsMachineShareWarmUpAndRepetitions() {
    assertThat(String.join("\n", tables("0.0150").head()))
        .contains("Lumbre " + Release.number() + " on Fast|er, 4 logical cores; VM 17; Linux")
        .contains("1.5 % of its samples", "extrapolated", "1 render of 1 sample per pixel")
        .contains("median of 3 renders");
    assertThat(String.join("\n", tables("1").head()))
        .contains("all of its samples")
        .doesNotContain("extrapolated");
  }

  @Test
  void shareOfARowIsMarkedAsExtrapolated() {
    String line = tables("0.01").line(BenchmarkFixture.result(BenchmarkFixture.row(1000), 10));
    assertThat(line)
        .startsWith("| 5 | Hearts | 8x4 | 10 of 1000 | 2 | 32 | 5 | Fast\\|er | 12s 500ms | ")
        .contains(" 20m 50s 0ms extrapolated | i7, 8 threads | 1h | 26 | 80 |")
        .endsWith("| `0123456789abcdef` |");
  }

  @Test
  void wholeRowIsNotExtrapolated() {
    String line = tables("1").line(BenchmarkFixture.result(BenchmarkFixture.row(10), 10));
    assertThat(line)
        .contains("| 8x4 | 10 | 2 |", "| 12s 500ms | 12s 500ms | i7")
        .doesNotContain("extrapolated");
  }

  @Test
  void everyLineHasACellForEachColumn() {
    List<String> head = tables("1").head();
    String line = tables("1").line(BenchmarkFixture.result(BenchmarkFixture.row(10), 10));
    assertThat(cells(head.get(head.size() - 2))).isEqualTo(15);
    assertThat(cells(head.get(head.size() - 1))).isEqualTo(15);
    assertThat(cells(line)).isEqualTo(15);
  }

  private static int cells(String line) {
    return line.replace("\\|", "").split("\\|").length - 1;
  }

  @Test
  void oddRowsAreMarkedAndExplained() {
    BenchmarkResult odd = BenchmarkFixture.result(BenchmarkFixture.rayRow("a slip."), 1);
    BenchmarkResult plain = BenchmarkFixture.result(BenchmarkFixture.row(10), 10);
    assertThat(tables("0.01").line(odd))
        .contains("| 1 of 4 (ray tracing) |", "| N/A |", "| 16s (note) |");
    assertThat(tables("0.01").foot(List.of(plain, odd)))
        .containsExactly("", "- Note on row 9: a slip.");
    assertThat(tables("0.01").foot(List.of(plain))).isEmpty();
  }

  @Test
  void fileForProgramsHasAValueForEachName() {
    BenchmarkTables tables = tables("0.01");
    ReportRow odd = BenchmarkFixture.rayRow("a slip, \"of\" sorts");
    String text =
        tables.csv(
            List.of(
                BenchmarkFixture.result(BenchmarkFixture.row(1000), 10),
                BenchmarkFixture.result(odd, 1)));
    List<List<String>> lines = text.lines().map(Csv::values).toList();
    assertThat(lines).hasSize(3).allMatch(line -> line.size() == lines.get(0).size());
    assertThat(value(lines, 1, "samples")).isEqualTo("10");
    assertThat(value(lines, 1, "all_samples")).isEqualTo("1000");
    assertThat(value(lines, 1, "seconds")).isEqualTo("12.500");
    assertThat(value(lines, 1, "all_seconds")).isEqualTo("1250.000");
    assertThat(value(lines, 1, "extrapolated")).isEqualTo("true");
    assertThat(value(lines, 1, "all_time")).isEqualTo("20m 50s 0ms");
    assertThat(value(lines, 1, "report_time")).isEqualTo("1h");
    assertThat(value(lines, 1, "image_sha256")).isEqualTo(BenchmarkFixture.HASH);
    assertThat(value(lines, 1, "cpu")).isEqualTo("Fast|er");
    assertThat(value(lines, 2, "depth")).isEmpty();
    assertThat(value(lines, 2, "mode")).isEqualTo("ray");
    assertThat(value(lines, 2, "note")).isEqualTo("a slip, \"of\" sorts");
  }

  private static String value(List<List<String>> lines, int line, String name) {
    return lines.get(line).get(lines.get(0).indexOf(name));
  }

  @Test
  void medianIsTheMiddle() {
    assertThat(Interval.median(7)).isEqualTo(7);
    assertThat(Interval.median(9, 1, 4)).isEqualTo(4);
    assertThat(Interval.median(9, 1, 4, 5)).isEqualTo(4.5);
  }
}
