package io.github.lumbre.material.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.math.internal.Elementary;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the sampling of visible slopes against their distribution. */
class VisibleSlopeTest {
  private static final int DRAWS = 20_000;

  private static double share(double cos, double sin, double slope) {
    double last = cos < VisibleSlope.STEEPEST * sin ? cos / sin : VisibleSlope.STEEPEST;
    return below(cos, sin, slope) / below(cos, sin, last);
  }

  private static double below(double cos, double sin, double slope) {
    return VisibleSlope.cumulative(cos, sin, slope, Elementary.exp(-slope * slope));
  }

  /** Errors are relative to the nearer end, so that the test covers the tails. */
  @ParameterizedTest
  @ValueSource(doubles = {1, 1 - 1e-12, .999, .9, .5, .1, 1e-3, 1e-6, 1e-12})
  void theShareOfSlopesBelowTheOneDrawnIsTheNumberDrawn(double cos) {
    double sin = Math.sqrt((1 - cos) * (1 + cos));
    SplittableRandom random = new SplittableRandom(5);
    for (int i = 0; i < DRAWS; i++) {
      double nearer = i % 2 == 0 ? random.nextDouble(.5) : Math.pow(10, -random.nextDouble(.3, 10));
      double u = random.nextBoolean() ? nearer : 1 - nearer;
      double drawn = share(cos, sin, VisibleSlope.at(cos, sin, u));
      assertThat(Math.abs(drawn - u)).isLessThan(1e-5 * Math.min(u, 1 - u));
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, .7, .1, 1e-9, 0})
  void extremeNumbersGiveSlopesThatCanBeSeen(double cos) {
    double sin = Math.sqrt((1 - cos) * (1 + cos));
    for (double u : new double[] {0, Double.MIN_VALUE, 1e-300, 0x1p-33, 1 - 0x1p-33, 1}) {
      double slope = VisibleSlope.at(cos, sin, u);
      assertThat(slope).isBetween(-VisibleSlope.STEEPEST, VisibleSlope.STEEPEST);
      assertThat(cos - slope * sin).isGreaterThanOrEqualTo(-1e-15);
    }
  }
}
