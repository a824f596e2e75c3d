package io.github.lumbre.image.format.svg;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SvgWriterTest {
  @ParameterizedTest
  @CsvSource({
    "0, 0", "-0.0, 0", "12.5, 12.5", "-12.3456, -12.346", "0.0004, 0", "1e-3, 0.001", "100, 100",
    "1e300, 1000000000000", "-Infinity, -1000000000000", "NaN, 0", "0.05, 0.05"
  })
  void numbersAreShortDecimals(double value, String text) {
    assertThat(SvgWriter.number(value)).isEqualTo(text);
  }

  @Test
  void charactersThatXmlCannotHoldAreReplaced() {
    assertThat(SvgWriter.escaped("a\0\n\u001b\ufffe\ud800b\u0085"))
        .isEqualTo("a\ufffd\ufffd\ufffd\ufffd\ufffdb\ufffd");
    assertThat(SvgWriter.escaped("<&>\"'\ud83d\ude00"))
        .isEqualTo("&lt;&amp;&gt;&quot;&#39;\ud83d\ude00");
  }
}
