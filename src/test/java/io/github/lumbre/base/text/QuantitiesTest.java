package io.github.lumbre.base.text;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the numbers on labels. */
class QuantitiesTest {
  @ParameterizedTest
  @CsvSource({
    "12.5, millimeter, 12.5 mm",
    "0.1, meter, 0.1 m",
    "12.3456, '', 12.35",
    "1000000, inch, 1000000 in",
    "1234567, foot, 1235000 ft",
    "0.000001, micron, 0.000001 µm",
    "1.23456e-8, centimeter, 1.235e-8 cm",
    "9.87654e20, '', 9.877e20",
    "0, meter, 0 m",
    "40, units, 40 units"
  })
  void numbersHaveFourDigits(double value, String unit, String text) {
    assertThat(Quantities.text(value, unit)).isEqualTo(text);
  }

  @ParameterizedTest
  @CsvSource({
    "1, 1",
    "1.99, 1",
    "2, 2",
    "4.99, 2",
    "5, 5",
    "9.99, 5",
    "10, 10",
    "0.37, 0.2",
    "7e-9, 5e-9",
    "3e17, 2e17"
  })
  void scaleBarsHaveRoundLengths(double most, double length) {
    assertThat(Quantities.roundDown(most)).isEqualTo(length);
  }
}
