package io.github.lumbre.math.sampling.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.testing.ChiSquare;
import io.github.lumbre.testing.Effort;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests the sampling of discrete distributions. */
class Distribution1dTest {
  private static final double EPS = 0x1p-52;
  private static final double LAST = 1 - 0x1p-53;

  private final SplittableRandom random = new SplittableRandom(Effort.seed(9));

  private static double sumOfProbabilities(Distribution1d distribution) {
    double sum = 0;
    for (int i = 0; i < distribution.size(); i++) {
      sum += distribution.probability(i);
    }
    return sum;
  }

  @Test
  void itemsAreDrawnInProportionToTheirWeights() {
    double[] weights = random.doubles(100).map(x -> x * x * x).toArray();
    weights[17] = 0;
    Distribution1d distribution = new Distribution1d(weights);
    int n = 300_000;
    long[] counts = new long[100];
    double[] expected = new double[100];
    for (int i = 0; i < n; i++) {
      counts[distribution.choose(random.nextDouble())]++;
    }
    for (int i = 0; i < 100; i++) {
      expected[i] = n * distribution.probability(i);
      assertThat(distribution.probability(i))
          .isCloseTo(weights[i] / (100 * distribution.mean()), within(4 * EPS));
    }
    assertThat(ChiSquare.of(counts, expected).passes()).isTrue();
  }

  @Test
  void itemsWithoutWeightAreNeverDrawn() {
    Distribution1d distribution = new Distribution1d(0, 0, 1, 0, 3, 0, 0, 0, 2, 0, 0);
    for (int i = 0; i <= 6000; i++) {
      for (double u : new double[] {i / 6000.0, Math.nextDown(i / 6000.0)}) {
        if (u >= 0 && u < 1) {
          assertThat(distribution.choose(u)).isIn(2, 4, 8);
        }
      }
    }
    assertThat(distribution.choose(0)).isEqualTo(2);
    assertThat(distribution.choose(LAST)).isEqualTo(8);
    assertThat(distribution.probability(3)).isZero();
  }

  /** Integer weights whose sum is a power of two have exact cumulative weights. */
  @Test
  void everyItemIsDrawnFromItsOwnIntervalToTheBit() {
    int total = 1 << 12;
    for (int items : new int[] {1, 2, 3, 7, 8, 9, 31, 33, 1000, 1024}) {
      int[] weights = new int[items];
      for (int i = 0; i < total; i++) {
        int item = random.nextInt(items);
        weights[random.nextInt(4) == 0 ? item / 8 : item]++;
      }
      Distribution1d distribution =
          new Distribution1d(Arrays.stream(weights).asDoubleStream().toArray());
      int begin = 0;
      for (int item = 0; item < items; item++) {
        int end = begin + weights[item];
        if (begin < end) {
          double first = (double) begin / total;
          double last = Math.nextDown((double) end / total);
          assertThat(distribution.choose(first)).isEqualTo(item);
          assertThat(distribution.choose(random.nextDouble(first, last))).isEqualTo(item);
          assertThat(distribution.choose(last)).isEqualTo(item);
        }
        begin = end;
      }
    }
  }

  @Test
  void extremeWeightsKeepTheirProportions() {
    for (double scale : new double[] {Double.MIN_VALUE, 1e-300, 1e300, 4e307}) {
      Distribution1d distribution = new Distribution1d(scale, 0, 3 * scale);
      assertThat(distribution.probability(0)).isEqualTo(.25);
      assertThat(distribution.probability(2)).isEqualTo(.75);
      assertThat(distribution.choose(Math.nextDown(.25))).isZero();
      assertThat(distribution.choose(.25)).isEqualTo(2);
    }
    Distribution1d mixed = new Distribution1d(1e-300, 1e300, 1e-300, 0);
    assertThat(sumOfProbabilities(mixed)).isEqualTo(1);
    assertThat(mixed.choose(LAST)).isEqualTo(1);
  }

  @Test
  void singleItemIsAlwaysDrawn() {
    Distribution1d distribution = new Distribution1d(1e-300);
    assertThat(distribution.probability(0)).isEqualTo(1);
    assertThat(distribution.choose(LAST)).isZero();
    assertThat(distribution.remainder(0, .3)).isEqualTo(.3);
    assertThat(distribution.mean()).isEqualTo(1e-300);
  }

  @Test
  void manyItemsSumToOne() {
    double[] weights =
        random.doubles(Effort.count(100_000, 1_000_000)).map(x -> x < .3 ? 0 : x).toArray();
    Distribution1d distribution = new Distribution1d(weights);
    assertThat(sumOfProbabilities(distribution)).isCloseTo(1, within(4 * EPS));
    for (int i = 0; i < 100_000; i++) {
      assertThat(weights[distribution.choose(random.nextDouble())]).isPositive();
    }
    assertThat(weights[distribution.choose(LAST)]).isPositive();
  }

  @Test
  void withoutAnyWeightTheChoiceIsUniform() {
    Distribution1d distribution = new Distribution1d(0, 0, 0, 0);
    for (int i = 0; i < 4; i++) {
      assertThat(distribution.probability(i)).isEqualTo(.25);
      assertThat(distribution.choose(i / 4.0)).isEqualTo(i);
    }
    assertThat(distribution.mean()).isZero();
  }

  @Test
  void remainderIsUniformAndContinuesTheNumber() {
    Distribution1d distribution = new Distribution1d(1, 0, 2, 5);
    long[] counts = new long[64];
    for (int i = 0; i < 100_000; i++) {
      double u = random.nextDouble();
      int item = distribution.choose(u);
      double remainder = distribution.remainder(item, u);
      assertThat(remainder).isBetween(0.0, LAST);
      counts[(int) (64 * remainder)]++;
    }
    assertThat(ChiSquare.uniform(counts).passes()).isTrue();
    assertThat(distribution.remainder(2, .25)).isEqualTo(.5);
    assertThat(distribution.remainder(3, LAST)).isBetween(1 - 4 * EPS, LAST);
  }

  @Test
  void weightsThatAreNoWeightsAreRefused() {
    assertThatThrownBy(Distribution1d::new).hasMessageContaining("found none");
    assertThatThrownBy(() -> new Distribution1d(1, -1)).hasMessageContaining("found -1");
    assertThatThrownBy(() -> new Distribution1d(Double.NaN)).hasMessageContaining("NaN");
    assertThatThrownBy(() -> new Distribution1d(1 / 0.0)).hasMessageContaining("Infinity");
  }
}
