package io.github.lumbre.render.stopping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the quantiles of the normal distribution. */
class NormalTest {
  /** Abramowitz and Stegun 1964, table 26.5. */
  @ParameterizedTest
  @CsvSource({".5, 0", ".1, 1.281552", ".05, 1.644854", ".025, 1.959964", ".001, 3.090232"})
  void quantilesAreThoseOfTheTable(double probability, double z) {
    assertThat(Normal.exceeded(probability)).isCloseTo(z, within(2e-6));
  }

  @Test
  void quantilesUndoProbabilities() {
    for (double z = 0; z < 30; z += .37) {
      assertThat(Normal.exceeded(Normal.beyond(z))).isCloseTo(z, within(1e-9));
    }
  }
}
