package io.github.lumbre.lab;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests the quoting and parsing of CSV lines. */
class CsvTest {
  @Test
  void valuesThatNeedQuotesGetThem() {
    assertThat(Csv.line(List.of("a b", 1, "c,d", "say \"e\"", "")))
        .isEqualTo("a b,1,\"c,d\",\"say \"\"e\"\"\",");
  }

  @Test
  void linesAreReadAsTheyWereWritten() {
    for (List<String> values :
        List.of(
            List.of(""),
            List.of("", ""),
            List.of("a", ""),
            List.of("\"", "\"\"", ",\",", "x,"),
            List.of("1", "é ≈", " spaced "))) {
      assertThat(Csv.values(Csv.line(values))).isEqualTo(values);
    }
  }

  @Test
  void openQuotesAreRefused() {
    assertThatIllegalArgumentException().isThrownBy(() -> Csv.values("a,\"b"));
  }
}
