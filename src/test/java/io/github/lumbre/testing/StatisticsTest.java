package io.github.lumbre.testing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests the significance tests and their power. */
class StatisticsTest {
  private static final double UNIFORM_DEVIATION = Math.sqrt(1 / 12.0);

  private final SplittableRandom random = new SplittableRandom(1);

  @Test
  void momentsAreThoseOfKnownNumbers() {
    Moments moments = new Moments();
    for (double value : new double[] {1e8 + 2, 1e8 + 4, 1e8 + 4, 1e8 + 4, 1e8 + 5, 1e8 + 11}) {
      moments.add(value);
    }
    assertThat(moments.count()).isEqualTo(6);
    assertThat(moments.mean()).isEqualTo(1e8 + 5);
    assertThat(moments.variance()).isCloseTo(9.6, within(1e-6));
  }

  @Test
  void unbiasedMeanPasses() {
    Moments moments = Statistics.moments(100_000, random::nextDouble);
    assertThat(Math.abs(moments.z(.5))).isLessThan(Statistics.CRITICAL_Z);
  }

  @Test
  void plantedBiasIsFoundWithTheStatedPower() {
    double bias = .01;
    int needed = Statistics.samplesToDetect(bias, UNIFORM_DEVIATION);
    int found = 0;
    for (int run = 0; run < 500; run++) {
      Moments moments = Statistics.moments(needed, () -> random.nextDouble() + bias);
      found += moments.z(.5) > Statistics.CRITICAL_Z ? 1 : 0;
    }
    // Of 500 runs, 495 ± 2.2 detect it; 482 is 6 sigma below.
    assertThat(found).isGreaterThanOrEqualTo(482);
  }

  @Test
  void twoSampleTestFindsBiasAndOnlyBias() {
    // The difference has twice the variance of either mean.
    int needed = Statistics.samplesToDetect(.01, UNIFORM_DEVIATION * Math.sqrt(2));
    Moments a = Statistics.moments(needed, random::nextDouble);
    Moments b = Statistics.moments(needed, random::nextDouble);
    Moments biased = Statistics.moments(needed, () -> random.nextDouble() + .01);
    assertThat(Math.abs(a.z(b))).isLessThan(Statistics.CRITICAL_Z);
    assertThat(biased.z(a)).isGreaterThan(Statistics.CRITICAL_Z);
    assertThat(a.z(biased)).isLessThan(-Statistics.CRITICAL_Z);
  }

  @Test
  void equalSamplesAreExactlyRightOrInfinitelyWrong() {
    Moments moments = Statistics.moments(100, () -> .25);
    assertThat(moments.z(.25)).isZero();
    assertThat(moments.z(.5)).isEqualTo(Double.NEGATIVE_INFINITY);
  }

  @Test
  void fewSamplesAreRefused() {
    Moments few = Statistics.moments(99, random::nextDouble);
    Moments enough = Statistics.moments(100, random::nextDouble);
    assertThatThrownBy(() -> few.z(.5)).hasMessageContaining("found 99");
    assertThatThrownBy(() -> enough.z(few)).hasMessageContaining("found 99");
    assertThatThrownBy(() -> Statistics.correlationZ(new double[99], new double[99]))
        .hasMessageContaining("found 99");
  }

  @Test
  void correlationIsThatOfKnownPairs() {
    double[] a = {1, 2, 3, 4};
    assertThat(Statistics.correlation(a, new double[] {3, 5, 7, 9})).isCloseTo(1, within(1e-15));
    assertThat(Statistics.correlation(a, new double[] {2, 1, 0, -1})).isCloseTo(-1, within(1e-15));
    assertThat(Statistics.correlation(a, new double[] {1, -1, -1, 1})).isZero();
  }

  @Test
  void plantedCorrelationIsFound() {
    // z = r√n = 10, so all but 2e-7 of the runs detect it.
    int n = 100_000;
    double[] a = random.doubles(n).toArray();
    double[] b = random.doubles(n).toArray();
    double[] mixed = new double[n];
    for (int i = 0; i < n; i++) {
      mixed[i] = b[i] + 10 / Math.sqrt(n) * a[i];
    }
    assertThat(Math.abs(Statistics.correlationZ(a, b))).isLessThan(Statistics.CRITICAL_Z);
    assertThat(Statistics.correlationZ(a, mixed)).isGreaterThan(Statistics.CRITICAL_Z);
  }

  @Test
  void slopeIsThatOfAStraightLine() {
    assertThat(Statistics.slope(new double[] {0, 1, 5}, new double[] {7, 5, -3})).isEqualTo(-2);
  }
}
