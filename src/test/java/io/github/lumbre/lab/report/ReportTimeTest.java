package io.github.lumbre.lab.report;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the time format of the report. */
class ReportTimeTest {
  @ParameterizedTest
  @CsvSource({
    "0,              0ms",
    "0.0124,         12ms",
    "0.9996,         1s 0ms",
    "16.833,         16s 833ms",
    "59.9995,        1m 0s 0ms",
    "85.703,         1m 25s 703ms",
    "3600,           1h 0m 0s 0ms",
    "5192.336,       1h 26m 32s 336ms",
    "42821.621,      11h 53m 41s 621ms",
    "360001.0,       100h 0m 1s 0ms"
  })
  void timesAreWrittenAsInTheReport(double seconds, String text) {
    assertThat(ReportTime.of(seconds)).isEqualTo(text);
  }
}
