package io.github.lumbre.render.stopping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.render.PixelHalves;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Tests the noise estimate and its confidence bound. */
class NoiseEstimatorTest {
  private static NoiseEstimate estimate(double confidence, double... errors) {
    NoiseEstimator estimator = new NoiseEstimator();
    for (double error : errors) {
      estimator.add(error, error, 32);
    }
    return estimator.estimate(confidence);
  }

  /** For normal samples, the expected squared error of the mean is σ²/n. */
  @Test
  void independentSamplesAreEstimatedWithoutBias() {
    Random random = new Random(7);
    int[][] parts = {{1, 1}, {64, 64}, {64, 32}, {64, 1}};
    for (int[] n : parts) {
      double sum = 0;
      int pixels = 200_000;
      for (int i = 0; i < pixels; i++) {
        Rgb a = Rgb.gray(10 + random.nextGaussian() / Math.sqrt(n[0]));
        Rgb b = Rgb.gray(10 + random.nextGaussian() / Math.sqrt(n[1]));
        sum += new PixelHalves(n[0], a, n[1], b).relativeSquaredError();
      }
      double expected = 1.0 / (n[0] + n[1]) / 100.01;
      // The standard error is 0.3 %; at one tenth of a sample, 1/r² differs by another 3 %.
      assertThat(sum / pixels).isCloseTo(expected, within(.05 * expected));
    }
  }

  /** For a spot of value V that one of 2 n samples hits, the error is V² p / (n 0.01) for any V. */
  @Test
  void brightSpotsDoNotHideInTheirOwnBrightness() {
    Rgb bright = Rgb.gray(1000);
    double error = new PixelHalves(32, bright, 32, Rgb.BLACK).relativeSquaredError();
    assertThat(error).isCloseTo(1000 * 1000 / 4.0 / .01, within(1.0));
  }

  @Test
  void boundHoldsAsOftenAsItSays() {
    Random random = new Random(11);
    int misses = 0;
    for (int run = 0; run < 4000; run++) {
      double[] errors = new double[256];
      double own = 0;
      for (int i = 0; i < errors.length; i++) {
        double scale = i % 4;
        double z = random.nextGaussian();
        errors[i] = scale * z * z;
        double y = random.nextGaussian();
        own += scale * y * y / errors.length;
      }
      misses += own > estimate(.95, errors).upperRelativeMse() ? 1 : 0;
    }
    // At most 5 %: 200, plus 3.1 standard deviations of 14.
    assertThat(misses).isBetween(40, 243);
  }

  @Test
  void moreConfidenceTakesAHigherBound() {
    double[] errors = new Random(1).doubles(1000).toArray();
    assertThat(estimate(.99, errors).upperRelativeMse())
        .isGreaterThan(estimate(.9, errors).upperRelativeMse());
    assertThat(estimate(.9, errors).relativeMse()).isEqualTo(estimate(.99, errors).relativeMse());
  }

  @Test
  void fewPixelsHaveNoBound() {
    assertThat(estimate(.95, new double[63]).upperRelativeMse()).isInfinite();
    assertThat(estimate(.95, new double[64]).upperRelativeMse()).isZero();
  }

  /** An outlier of 5,000 has half of the noise of 10,000 pixels of .5 each. */
  @Test
  void outliersMakeABoundDoubtful() {
    double[] errors = new Random(3).doubles(10_000).toArray();
    assertThat(estimate(.95, errors).isDoubtful()).isFalse();
    assertThat(estimate(.95, errors).outlierShare()).isZero();
    errors[500] = 1000;
    assertThat(estimate(.95, errors).isDoubtful()).isFalse();
    assertThat(estimate(.95, errors).outlierShare()).isCloseTo(1 / 6.0, within(.01));
    errors[500] = 5000;
    assertThat(estimate(.95, errors).isDoubtful()).isTrue();
    assertThat(estimate(.95, errors).outlierShare()).isCloseTo(.5, within(.01));
  }

  @Test
  void doubtfulBoundsEndNoRender() {
    Budget budget = new Budget(64, OptionalDouble.of(.5), .95);
    assertThat(budget.isReachedBy(new NoiseEstimate(.1, .2, .95, .25, 100))).isTrue();
    assertThat(budget.isReachedBy(new NoiseEstimate(.1, .2, .95, .26, 100))).isFalse();
    assertThat(budget.isReachedBy(new NoiseEstimate(.1, .3, .95, 0, 100))).isFalse();
  }

  /** Nine pixels of 1 to 9 in a film of 3x3: each is compared with the mean of the others. */
  @Test
  void surroundingsLeaveOutThePixelAndWhatIsOutsideTheFilm() {
    HalvesRow[] rows = new HalvesRow[3];
    for (int y = 0; y < 3; y++) {
      double[] means = new double[9];
      for (int i = 0; i < 9; i++) {
        means[i] = 3 * y + i / 3 + 1;
      }
      rows[y] = new HalvesRow(new PixelHalves[3], means);
    }
    assertThat(HalvesRow.surroundings(rows[0], rows[1], rows[2], 1)).isEqualTo(Rgb.gray(5));
    assertThat(HalvesRow.surroundings(rows[0], rows[1], rows[2], 0).g())
        .isCloseTo((1 + 2 + 5 + 7 + 8) / 5.0, within(1e-12));
    assertThat(HalvesRow.surroundings(HalvesRow.NONE, rows[0], rows[1], 2).b())
        .isCloseTo((2 + 5 + 6) / 3.0, within(1e-12));
    HalvesRow single = new HalvesRow(new PixelHalves[1], new double[] {4, 4, 4});
    assertThat(HalvesRow.surroundings(HalvesRow.NONE, single, HalvesRow.NONE, 0))
        .isEqualTo(Rgb.BLACK);
  }

  /** The error of a sample that is 20 times as bright as what surrounds it, of few samples. */
  @Test
  void singleSamplesOfFewAreNoOutliers() {
    NoiseEstimator few = new NoiseEstimator();
    few.add(25, 25, 4);
    assertThat(few.estimate(.95).outlierShare()).isZero();
    NoiseEstimator many = new NoiseEstimator();
    many.add(25, 25, 32);
    assertThat(many.estimate(.95).outlierShare()).isEqualTo(1);
  }

  @Test
  void estimateLiesBetweenThoseOfPixelsAloneAndAmongOthers() {
    NoiseEstimator estimator = new NoiseEstimator();
    for (int i = 0; i < 100; i++) {
      estimator.add(1, 4, 32);
    }
    assertThat(estimator.estimate(.95).relativeMse()).isEqualTo(2);
    // exp(1.645 √(4 / 100)) = 1.39 times the larger.
    assertThat(estimator.estimate(.95).upperRelativeMse()).isCloseTo(4 * 1.3896, within(.001));
  }

  @Test
  void looksSpendNoMoreThanTheyMay() {
    double spent = 3 * (1 - StoppingSchedule.earlyConfidence(.95));
    assertThat(spent).isCloseTo(.005, within(1e-12));
    for (int look = 1; look < 1000; look++) {
      spent += 1 - StoppingSchedule.confidence(.95, look);
    }
    assertThat(spent).isBetween(.0499, .05);
    assertThat(
            IntStream.range(1, 200)
                .filter(n -> StoppingSchedule.due(n) > StoppingSchedule.due(n - 1)))
        .containsExactly(4, 8, 16, 32, 48, 64, 96, 128, 192);
  }

  /**
   * The part of the picture that could hide an error of ε is its fraction ε², which needs 256
   * samples.
   */
  @Test
  void earlyLooksNeedEnoughSamplesToFindWhatMatters() {
    assertThat(StoppingSchedule.isEarlyEnough(4, 640 * 480, .2)).isTrue();
    assertThat(StoppingSchedule.isEarlyEnough(4, 1600, .2)).isTrue();
    assertThat(StoppingSchedule.isEarlyEnough(4, 1599, .2)).isFalse();
    assertThat(StoppingSchedule.isEarlyEnough(16, 400, .2)).isTrue();
    assertThat(StoppingSchedule.isEarlyEnough(16, 399, .2)).isFalse();
    assertThat(StoppingSchedule.isEarlyEnough(16, 640 * 480, .001)).isFalse();
    assertThat(StoppingSchedule.isEarlyEnough(32, 64, .001)).isTrue();
  }
}
