package io.github.lumbre.math.sampling.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.testing.ChiSquare;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Moments;
import io.github.lumbre.testing.Statistics;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.LongFunction;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;

/** Tests the low-discrepancy points of the Sobol sampler and their scrambling. */
class SobolSamplerTest {
  private final SplittableRandom random = new SplittableRandom(6);

  private static double value(SobolSampler sampler, int x, int y, int sample, int dimension) {
    sampler.startSample(x, y, sample);
    return sampler.get1d(dimension);
  }

  @Test
  void mixIsSplitMix64() {
    // The published outputs for seed 0: the state increases by the golden ratio before each output.
    long golden = 0x9e3779b97f4a7c15L;
    assertThat(Hash.mix(golden)).isEqualTo(0xe220a8397b1dcdafL);
    assertThat(Hash.mix(2 * golden)).isEqualTo(0x6e789e6aa1b965f4L);
    assertThat(Hash.mix(3 * golden)).isEqualTo(0x06c45d188009454fL);
  }

  @Test
  void secondDimensionIsPascalsTriangle() {
    // Direction number j of the second dimension has bit i from the top set if C(j, i) is odd.
    int[] directions = new int[32];
    for (int j = 0; j < 32; j++) {
      for (int i = 0; i <= j; i++) {
        directions[j] |= (j & i) == i ? 1 << (31 - i) : 0;
      }
    }
    assertThat(Arrays.copyOf(directions, 4))
        .containsExactly(0x80000000, 0xc0000000, 0xa0000000, 0xf0000000);
    for (int n = 0; n < 100_000; n++) {
      int index = n < 1000 ? n : random.nextInt();
      int expected = 0;
      for (int j = 0; j < 32; j++) {
        expected ^= (index >>> j & 1) == 1 ? directions[j] : 0;
      }
      assertThat(Integer.reverse(SobolSampler.reversedSecondDimension(index))).isEqualTo(expected);
    }
  }

  @Test
  void scramblingMovesEachBitByLowerOnesOnly() {
    for (int n = 0; n < 10_000; n++) {
      int x = random.nextInt();
      int key = random.nextInt();
      int bit = random.nextInt(32);
      int changed = SobolSampler.scramble(x, key) ^ SobolSampler.scramble(x ^ 1 << bit, key);
      assertThat(Integer.lowestOneBit(changed)).isEqualTo(1 << bit);
    }
  }

  @Test
  void valueIsAFunctionOfTheAddressAlone() {
    SobolSampler first = new SobolSampler(42);
    SobolSampler second = new SobolSampler(42);
    int n = 1000;
    int[][] addresses = new int[n][];
    double[] values = new double[n];
    for (int i = 0; i < n; i++) {
      addresses[i] =
          new int[] {
            random.nextInt(65535),
            random.nextInt(65535),
            random.nextInt(1 << 30),
            random.nextInt(99)
          };
      int[] a = addresses[i];
      values[i] = value(first, a[0], a[1], a[2], a[3]);
    }
    for (int i = n - 1; i >= 0; i--) {
      int[] a = addresses[i];
      assertThat(value(second, a[0], a[1], a[2], a[3])).isEqualTo(values[i]);
    }
  }

  @Test
  void partsOfASampleHaveTheNumbersOfMoreSamples() {
    for (LongFunction<Sampler> samplers :
        List.<LongFunction<Sampler>>of(SobolSampler::new, IndependentSampler::new)) {
      Sampler whole = samplers.apply(5);
      Sampler parted = samplers.apply(5);
      for (int sample = 0; sample < 9; sample++) {
        for (int part = 0; part < 3; part++) {
          parted.startSample(4, 2, sample);
          parted.startPart(2 - part, 3);
          parted.startPart(part, 3);
          whole.startSample(4, 2, 3 * sample + part);
          assertThat(parted.get1d(12)).isEqualTo(whole.get1d(12));
          assertThat(parted.get2d(20)).isEqualTo(whole.get2d(20));
        }
      }
    }
  }

  @Test
  void valuesLieInTheUnitInterval() {
    SobolSampler sampler = new SobolSampler(-1);
    double least = 1;
    double most = 0;
    for (int i = 0; i < 200_000; i++) {
      sampler.startSample(random.nextInt(65535), random.nextInt(65535), random.nextInt(1 << 30));
      Point2 p = sampler.get2d(i % 50);
      least = Math.min(least, Math.min(p.x(), p.y()));
      most = Math.max(most, Math.max(p.x(), p.y()));
    }
    assertThat(least).isBetween(0.0, 1e-4);
    assertThat(most).isBetween(1 - 1e-4, Math.nextDown(1.0));
  }

  @Test
  void valuesOverPixelsAreUniform() {
    int rows = Effort.count(500, 25_000);
    for (long seed : new long[] {0, -1, Long.MAX_VALUE}) {
      SobolSampler sampler = new SobolSampler(Effort.seed(seed));
      long[] line = new long[256];
      long[] square = new long[1024];
      for (int y = 0; y < rows; y++) {
        for (int x = 0; x < 400; x++) {
          sampler.startSample(x, y, 5);
          line[(int) (256 * sampler.get1d(9))]++;
          Point2 p = sampler.get2d(3);
          square[32 * (int) (32 * p.y()) + (int) (32 * p.x())]++;
        }
      }
      assertThat(ChiSquare.uniform(line).passes()).isTrue();
      assertThat(ChiSquare.uniform(square).passes()).isTrue();
    }
  }

  /**
   * With the 200,000 pairs of a quick build, the test detects correlations of 0.016 or more with a
   * probability of 0.99.
   */
  @Test
  void neighbouringAddressesAreUncorrelated() {
    assertUncorrelated(7, 1, 0, 0);
    assertUncorrelated(7, 0, 1, 0);
    assertUncorrelated(7, 0, 0, 1);
    assertUncorrelated(7, 0, 0, Sampler.VERTEX_STRIDE);
    assertUncorrelated(8, 0, 0, 0);
    assertUncorrelated(7L << 32, 0, 0, 0);
  }

  /** Compares with the sampler of seed 7 at other pixels or dimensions. */
  private static void assertUncorrelated(long seed, int dx, int dy, int dimensions) {
    int n = Effort.count(200_000, 1_000_000);
    SobolSampler here = new SobolSampler(Effort.seed(7));
    SobolSampler there = new SobolSampler(Effort.seed(seed));
    double[] one = new double[n];
    double[] other = new double[n];
    double[] x = new double[n];
    double[] y = new double[n];
    for (int i = 0; i < n; i++) {
      one[i] = value(here, i % 500, i / 500, 3, 11);
      other[i] = value(there, i % 500 + dx, i / 500 + dy, 3, 11 + dimensions);
      x[i] = here.get2d(1).x();
      y[i] = there.get2d(1 + dimensions).y();
    }
    assertThat(Statistics.deviation(Statistics.correlationZ(one, other)))
        .isLessThan(Statistics.CRITICAL_Z);
    assertThat(Statistics.deviation(Statistics.correlationZ(x, y)))
        .isLessThan(Statistics.CRITICAL_Z);
    assertThat(Statistics.deviation(Statistics.correlationZ(one, x)))
        .isLessThan(Statistics.CRITICAL_Z);
  }

  @Test
  void dimensionsOfOnePixelFillTheirSquareTogether() {
    SobolSampler sampler = new SobolSampler(11);
    for (int pixel = 0; pixel < 10; pixel++) {
      long[] square = new long[1024];
      for (int i = 0; i < 1 << 16; i++) {
        sampler.startSample(pixel, 77, i);
        Point2 p = sampler.get2d(8);
        square[32 * (int) (32 * p.y()) + (int) (32 * sampler.get1d(10))]++;
      }
      assertThat(ChiSquare.uniform(square).passes()).isTrue();
    }
  }

  @Test
  void alignedBlocksHaveOnePointInEachElementaryInterval() {
    SobolSampler sampler = new SobolSampler(3);
    for (int bits = 0; bits <= 10; bits++) {
      int n = 1 << bits;
      for (int block : new int[] {0, 0, 0, 1, 2, 3, 5, 1000}) {
        int pixel = random.nextInt(65535);
        int dimension = random.nextInt(60);
        Point2[] points = new Point2[n];
        boolean[] line = new boolean[n];
        for (int i = 0; i < n; i++) {
          sampler.startSample(pixel, 65535 - pixel, block * n + i);
          points[i] = sampler.get2d(dimension);
          line[(int) (n * sampler.get1d(dimension + 2))] = true;
        }
        assertThat(line).doesNotContain(false);
        for (int columns = 0; columns <= bits; columns++) {
          assertOnePointEach(points, 1 << columns, n >> columns);
        }
      }
    }
  }

  private static void assertOnePointEach(Point2[] points, int columns, int rows) {
    boolean[] met = new boolean[points.length];
    for (Point2 p : points) {
      met[(int) (rows * p.y()) * columns + (int) (columns * p.x())] = true;
    }
    assertThat(met).as("%d x %d", columns, rows).doesNotContain(false);
  }

  @Test
  void anyNumberOfSamplesIsSpreadEvenly() {
    SobolSampler sampler = new SobolSampler(5);
    for (int n : new int[] {1, 2, 3, 7, 100, 997, 65537, 1_000_000}) {
      int[] strata = new int[64];
      for (int i = 0; i < n; i++) {
        sampler.startSample(n, 0, i);
        Point2 p = sampler.get2d(2);
        strata[8 * (int) (8 * p.y()) + (int) (8 * p.x())]++;
      }
      for (int count : strata) {
        assertThat(Math.abs(count - n / 64.0)).isLessThan(1);
      }
    }
  }

  @Test
  void errorsFallFasterThanThoseOfRandomNumbers() {
    // Independent numbers have order -0.5; stratified ones have orders -1 and -0.75.
    assertThat(order(p -> p.x() * p.x() * (1 + p.y()), .5)).isLessThan(-1.2);
    assertThat(order(p -> p.x() * p.x() + p.y() * p.y() < 1 ? 1 : 0, Math.PI / 4)).isLessThan(-.65);
  }

  /** Returns the slope of log RMSE over log n, from 16 to 1024 samples in 400 pixels. */
  private static double order(ToDoubleFunction<Point2> function, double integral) {
    SobolSampler sampler = new SobolSampler(1);
    double[] logCount = new double[7];
    double[] logError = new double[7];
    for (int k = 0; k < 7; k++) {
      int n = 16 << k;
      double squares = 0;
      for (int pixel = 0; pixel < 400; pixel++) {
        double sum = 0;
        for (int i = 0; i < n; i++) {
          sampler.startSample(pixel, k, i);
          sum += function.applyAsDouble(sampler.get2d(0));
        }
        squares += (sum / n - integral) * (sum / n - integral);
      }
      logCount[k] = Math.log(n);
      logError[k] = .5 * Math.log(squares / 400);
    }
    return Statistics.slope(logCount, logError);
  }

  @Test
  void meansOverManyPixelsAreUnbiased() {
    // The standard deviation of x²(1 + y) for one sample is below 0.5: the test detects a bias of
    // 0.004.
    SobolSampler sampler = new SobolSampler(9);
    int n = Statistics.samplesToDetect(.004, .5);
    int[] pixel = {0};
    Moments moments =
        Statistics.moments(
            n,
            () -> {
              sampler.startSample(pixel[0] % 3000, pixel[0]++ / 3000, 1);
              Point2 p = sampler.get2d(0);
              return p.x() * p.x() * (1 + p.y());
            });
    assertThat(Statistics.deviation(moments.z(.5))).isLessThan(Statistics.CRITICAL_Z);
  }

  @Test
  void hashesOfAKeyAreTheOutputsOfSplitMix64SeededWithIt() {
    for (long key : new long[] {0, 1, -5, Long.MAX_VALUE}) {
      // The reference implementation of the Java library.
      SplittableRandom outputs = new SplittableRandom(key);
      for (long number = 1; number < 100; number++) {
        assertThat(Hash.of(key, number)).isEqualTo(outputs.nextLong());
      }
    }
  }

  /** Films store the name: renders are resumed by it, so its numbers must never change. */
  @Test
  void numbersAreThoseThatTheNameStandsFor() {
    assertThat(SobolSampler.ID).isEqualTo("owen-sobol 1");
    assertNumbers(new SobolSampler(0), 0, 0, 0, 0, 0x1.32ec13aep-2, 0x1.07e0f09bp-1);
    assertNumbers(new SobolSampler(1), 1, 0, 0, 0, 0x1.0589496cp-3, 0x1.8c07d2cbp-1);
    assertNumbers(new SobolSampler(-7), 3, 4, 5, 6, 0x1.37e025fdp-1, 0x1.dc8db063p-1);
    SobolSampler far = new SobolSampler(1L << 40);
    assertNumbers(far, 65534, 1000, 123456789, 97, 0x1.f9d90b38p-4, 0x1.ec8cb61cp-3);
  }

  private static void assertNumbers(
      SobolSampler sampler, int x, int y, int sample, int dimension, double first, double second) {
    assertThat(value(sampler, x, y, sample, dimension)).isEqualTo(first);
    assertThat(sampler.get2d(dimension)).isEqualTo(new Point2(first, second));
  }

  @Test
  void everyPixelHasNumbersOfItsOwn() {
    for (Sampler sampler : new Sampler[] {new SobolSampler(2), new IndependentSampler(2)}) {
      Set<Double> values = new HashSet<>();
      for (int y = 0; y < 64; y++) {
        for (int x = 0; x < 64; x++) {
          sampler.startSample(x, y, 0);
          values.add(sampler.get1d(0));
        }
      }
      // Two of 4096 random numbers of 32 bits are equal with a probability of 1/500.
      assertThat(values).hasSizeGreaterThan(4096 - 3);
    }
  }

  /** The camera's dimensions, then those of one vertex after the other. */
  @Test
  void noTwoUsesShareADimension() {
    int[][] cameras = {{Sampler.FILM, 2}, {Sampler.LENS, 2}, {Sampler.MASK, 3}};
    int[][] uses = {
      {Sampler.LIGHT_CHOICE, 1},
      {Sampler.LIGHT_POINT, 2},
      {Sampler.LOBE, 1},
      {Sampler.DIRECTION, 2},
      {Sampler.ROULETTE, 1}
    };
    Set<Integer> taken = new HashSet<>();
    for (int[] use : cameras) {
      assertFree(taken, use[0], use[1]);
    }
    for (int vertex = 0; vertex < 100; vertex++) {
      for (int[] use : uses) {
        assertFree(taken, Sampler.vertex(vertex) + use[0], use[1]);
      }
    }
  }

  private static void assertFree(Set<Integer> taken, int first, int count) {
    for (int dimension = first; dimension < first + count; dimension++) {
      assertThat(dimension).isNotNegative();
      assertThat(taken.add(dimension)).as("dimension %d", dimension).isTrue();
    }
  }
}
