package io.github.lumbre.lab.metrics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Compares critical values of Student's t with tables. */
class StudentTTest {
  /** Abramowitz and Stegun 1964, table 26.10. */
  @ParameterizedTest
  @CsvSource({
    "0.95, 1, 12.706", "0.95, 2, 4.303", "0.95, 4, 2.776", "0.95, 8, 2.306",
    "0.95, 30, 2.042", "0.95, 120, 1.980", "0.95, 2000, 1.961", "0.99, 4, 4.604",
    "0.8, 10, 1.372"
  })
  void criticalValuesAreTheTabulatedOnes(double confidence, double degrees, double expected) {
    assertThat(StudentT.critical(confidence, degrees)).isCloseTo(expected, within(5.1e-4));
  }

  @Test
  void degreesNeedNotBeWhole() {
    assertThat(StudentT.critical(.95, 4.5))
        .isLessThan(StudentT.critical(.95, 4))
        .isGreaterThan(StudentT.critical(.95, 5));
  }
}
