package io.github.lumbre.math.sampling.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** Tests the weights of multiple importance sampling. */
class MisTest {
  private static final double[] DENSITIES = {
    0,
    Double.MIN_VALUE,
    1e-300,
    1e-9,
    .3,
    1,
    7,
    1e9,
    1e300,
    Double.MAX_VALUE,
    Double.POSITIVE_INFINITY
  };

  @Test
  void weightsOfTheTechniquesSumToOne() {
    for (double a : DENSITIES) {
      for (double b : DENSITIES) {
        assertThat(Mis.power(a, b) + Mis.power(b, a)).isCloseTo(1, within(0x1p-51));
        assertThat(Mis.power(a, b)).isBetween(0.0, 1.0);
        assertThat(Mis.balance(a, b) + Mis.balance(b, a)).isCloseTo(1, within(0x1p-51));
        assertThat(Mis.balance(a, b)).isBetween(0.0, 1.0);
      }
    }
  }

  @Test
  void weightIsTheSquaresShare() {
    assertThat(Mis.power(2, 1)).isEqualTo(.8);
    assertThat(Mis.power(1, 2)).isCloseTo(.2, within(0x1p-52));
    assertThat(Mis.power(3, 3)).isEqualTo(.5);
    assertThat(Mis.power(3e-200, 1e-200)).isCloseTo(.9, within(0x1p-52));
    assertThat(Mis.power(3e200, 1e200)).isCloseTo(.9, within(0x1p-52));
  }

  @Test
  void balancedWeightIsTheDensitysShare() {
    assertThat(Mis.balance(3, 1)).isEqualTo(.75);
    assertThat(Mis.balance(1, 3)).isCloseTo(.25, within(0x1p-52));
    assertThat(Mis.balance(3e-300, 1e-300)).isCloseTo(.75, within(0x1p-52));
  }

  @Test
  void techniqueWithoutRivalTakesAll() {
    assertThat(Mis.power(1e-300, 0)).isEqualTo(1);
    assertThat(Mis.power(0, 1e-300)).isZero();
    assertThat(Mis.power(Double.POSITIVE_INFINITY, 1e300)).isEqualTo(1);
    assertThat(Mis.power(1e300, Double.POSITIVE_INFINITY)).isZero();
    assertThat(Mis.power(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY)).isEqualTo(.5);
  }
}
