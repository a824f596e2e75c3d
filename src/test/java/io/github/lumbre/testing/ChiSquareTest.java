package io.github.lumbre.testing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Vec3;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;

/** Tests the χ² test itself. */
class ChiSquareTest {
  private static final int SAMPLES = 400_000;

  private final SplittableRandom random = new SplittableRandom(2);

  @Test
  void criticalValuesAreTheTabulatedOnes() {
    assertThat(ChiSquare.critical(255)).isCloseTo(377.08, within(.4));
    assertThat(ChiSquare.critical(1023)).isCloseTo(1252.58, within(.4));
    assertThat(ChiSquare.critical(4095)).isCloseTo(4539.7, within(.4));
  }

  @Test
  void statisticIsThatOfKnownCounts() {
    ChiSquare test = ChiSquare.of(new long[] {8, 12, 10}, new double[] {10, 10, 10});
    assertThat(test.statistic()).isCloseTo(.8, within(1e-15));
    assertThat(test.degrees()).isEqualTo(2);
    assertThat(test.passes()).isTrue();
  }

  @Test
  void smallCellsArePooled() {
    ChiSquare test = ChiSquare.of(new long[] {1, 3, 4, 92}, new double[] {2, 2, 2, 94});
    // 2 + 2 + 2 form a cell of 6 with a count of 8.
    assertThat(test.degrees()).isEqualTo(1);
    assertThat(test.statistic()).isCloseTo(4 / 6.0 + 4 / 94.0, within(1e-12));
  }

  @Test
  void oneSampleInAnImpossibleCellFails() {
    ChiSquare test = ChiSquare.of(new long[] {50_000, 50_000, 1}, new double[] {5e4, 5e4, 0});
    assertThat(test.impossible()).isEqualTo(1);
    assertThat(test.passes()).isFalse();
  }

  @Test
  void wrongSumsAreRefused() {
    assertThatThrownBy(() -> ChiSquare.of(new long[] {50, 50}, new double[] {50, 51}))
        .hasMessageContaining("found 101");
    assertThatThrownBy(() -> ChiSquare.of(new long[] {100}, new double[] {100}))
        .hasMessageContaining("at least 2");
  }

  @Test
  void uniformNumbersPassAndPlantedBiasFails() {
    assertThat(ChiSquare.uniform(histogram(0)).passes()).isTrue();
    // A density of 1 ± 3 % has the non-centrality n·0.03²/3 = 120 for 255 degrees, 5.3 sigma of
    // 22.6; 1 ± 5 % has 333, and practically always fails.
    assertThat(ChiSquare.uniform(histogram(.05)).passes()).isFalse();
  }

  private long[] histogram(double tilt) {
    long[] counts = new long[256];
    for (int i = 0; i < SAMPLES; ) {
      double x = random.nextDouble();
      if (random.nextDouble() * (1 + tilt) < 1 + tilt * (2 * x - 1)) {
        counts[(int) (256 * x)]++;
        i++;
      }
    }
    return counts;
  }

  @Test
  void directionsPassTheirDensityAndFailOthers() {
    assertThat(directions(d -> 1 / (4 * Math.PI)).passes()).isTrue();
    assertThat(directions(d -> (1 + .1 * d.x()) / (4 * Math.PI)).passes()).isFalse();
    assertThat(directions(d -> d.z() > .9999 ? 0 : 1 / (4 * Math.PI)).passes()).isFalse();
    assertThatThrownBy(() -> directions(d -> 1.01 / (4 * Math.PI))).hasMessageContaining("sum");
  }

  private ChiSquare directions(ToDoubleFunction<Vec3> pdf) {
    return ChiSquare.ofDirections(SAMPLES, () -> Optional.of(direction()), pdf, 2);
  }

  private Vec3 direction() {
    double z = 2 * random.nextDouble() - 1;
    double phi = 2 * Math.PI * random.nextDouble();
    double s = Math.sqrt(1 - z * z);
    return new Vec3(s * Math.cos(phi), s * Math.sin(phi), z);
  }
}
