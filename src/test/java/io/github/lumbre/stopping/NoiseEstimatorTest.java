package io.github.lumbre.stopping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.render.PixelHalves;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Tests the noise estimate and its confidence bound. */
class NoiseEstimatorTest {
  private static NoiseEstimate estimate(double confidence, double... errors) {
    NoiseEstimator estimator = new NoiseEstimator();
    for (double error : errors) {
      estimator.add(error);
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
        Rgb a = Rgb.grey(10 + random.nextGaussian() / Math.sqrt(n[0]));
        Rgb b = Rgb.grey(10 + random.nextGaussian() / Math.sqrt(n[1]));
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
    Rgb bright = Rgb.grey(1000);
    double error = new PixelHalves(32, bright, 32, Rgb.BLACK).relativeSquaredError();
    assertThat(error).isCloseTo(1000 * 1000 / 4.0 / .01, within(1.0));
  }

  /** A bright spot on a lit surface: the error is (.3 − 3)² / (.3² + .01), 73, in all channels. */
  @Test
  void brightSpotsOnLitSurfacesDoNotHideFromTheCautiousEstimate() {
    PixelHalves halves = new PixelHalves(2, Rgb.grey(6), 2, Rgb.grey(.3));
    assertThat(halves.relativeSquaredError()).isLessThan(6);
    assertThat(halves.cautiousSquaredError()).isGreaterThan(3 * halves.relativeSquaredError());
    PixelHalves even = new PixelHalves(2, Rgb.grey(.31), 2, Rgb.grey(.3));
    assertThat(even.cautiousSquaredError())
        .isCloseTo(even.relativeSquaredError(), within(.03 * even.relativeSquaredError()));
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

  @Test
  void heavyTailsAreFound() {
    double[] errors = new Random(3).doubles(10_000).toArray();
    assertThat(estimate(.95, errors).hasHeavyTail()).isFalse();
    assertThat(estimate(.95, errors).tailShare()).isCloseTo(.002, within(.0005));
    errors[500] = 1e5;
    assertThat(estimate(.95, errors).hasHeavyTail()).isTrue();
    assertThat(estimate(.95, errors).tailShare()).isGreaterThan(.9);
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
