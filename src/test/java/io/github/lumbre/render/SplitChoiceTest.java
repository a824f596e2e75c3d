package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

/**
 * Tests the choice of numbers of branches from errors and rays. Errors of a pixel are those of two
 * halves; their noise is that of the squared difference of two pictures.
 */
class SplitChoiceTest {
  private static final int PIXELS = 100;

  /** What is measured in a cell: shared and scattered error, rays of the shared part and others. */
  private record Cell(double shared, double scattered, double camera, double branch) {}

  private static SplitChoice choice(long seed, boolean isNoisy, Cell... cells) {
    return choice(seed, isNoisy, PIXELS, 1, cells);
  }

  /** Returns a choice; the error of unsplit paths falls by a power of their number, the rate. */
  private static SplitChoice choice(
      long seed, boolean isNoisy, int pixels, double rate, Cell... cells) {
    SplittableRandom random = new SplittableRandom(seed);
    DoubleUnaryOperator noise = e -> isNoisy ? e * square(normal(random)) : e;
    double[][][][] sums = new double[2][SplitChoice.GROUPS][cells.length][SplitChoice.KINDS];
    double fall = StrictMath.pow(SplitChoice.LONGER, -rate);
    for (int cell = 0; cell < cells.length; cell++) {
      for (int pixel = 0; pixel < pixels; pixel++) {
        for (int half = 0; half < 2; half++) {
          double[] sum = sums[half][pixel % SplitChoice.GROUPS][cell];
          double shared = noise.applyAsDouble(cells[cell].shared);
          sum[SplitChoice.ERROR] += shared + noise.applyAsDouble(cells[cell].scattered);
          sum[SplitChoice.SPLIT_ERROR] += shared + noise.applyAsDouble(cells[cell].scattered / 4);
          double error = cells[cell].shared + cells[cell].scattered;
          sum[SplitChoice.LONG_ERROR] += noise.applyAsDouble(error * fall);
          sum[SplitChoice.RAYS] += cells[cell].camera + cells[cell].branch;
          sum[SplitChoice.SPLIT_RAYS] += cells[cell].camera + 4 * cells[cell].branch;
        }
      }
    }
    return new SplitChoice(sums);
  }

  private static double square(double x) {
    return x * x;
  }

  private static double normal(SplittableRandom random) {
    double radius = Math.sqrt(-2 * StrictMath.log(1 - random.nextDouble()));
    return radius * StrictMath.cos(2 * Math.PI * random.nextDouble());
  }

  /** The gain with n branches is (1 + r) × 6 / ((1 + r / n) × (3 + 3 × n)) for a ratio r. */
  @Test
  void theNumberFollowsTheRatioOfErrorsAndRays() {
    for (double ratio : new double[] {.1, 1, 3.5}) {
      // With a ratio of 3.5, two branches are best, but they gain 1.09 only.
      assertThat(choice(1, false, new Cell(1, ratio, 3, 3)).choose().exponents())
          .containsExactly(0);
    }
    for (double ratio : new double[] {12, 16, 100}) {
      SplitChoice.Chosen chosen = choice(1, false, new Cell(1, ratio, 3, 3)).choose();
      assertThat(chosen.exponents()).containsExactly(2);
      double gain = (1 + ratio) * 6 / ((1 + ratio / 4) * 15);
      assertThat(chosen.gain()).isCloseTo(gain, within(1e-12));
      assertThat(chosen.bound()).isCloseTo(gain, within(1e-12));
    }
  }

  /**
   * Branches compete with more samples. At a rate of 2, four times as many have a sixteenth of the
   * error, so that a quarter of the error is worth twice the rays, and not four times.
   */
  @Test
  void theGainIsInRaysForTheSameError() {
    for (double rate : new double[] {1, 1.25, 2}) {
      SplitChoice.Chosen chosen =
          choice(1, false, PIXELS, rate, new Cell(0, 1, 5, 1)).choose();
      assertThat(chosen.exponents()).containsExactly(2);
      double gain = StrictMath.pow(4, 1 / rate) * 6 / 9;
      assertThat(chosen.gain()).isCloseTo(gain, within(1e-12));
    }
    // 4 times the rays: no gain at a rate above 1. Slower than at random, at a rate below 1, is noise.
    Cell dear = new Cell(0, 1, 0, 1);
    for (double rate : new double[] {.5, 1, 1.5}) {
      SplitChoice.Chosen chosen = choice(1, false, PIXELS, rate, dear).choose();
      assertThat(chosen.exponents()).containsExactly(0);
    }
  }

  private static org.assertj.core.data.Offset<Double> within(double error) {
    return org.assertj.core.data.Offset.offset(error);
  }

  @Test
  void cellsHaveTheirOwnNumbers() {
    Cell direct = new Cell(.1, .01, 1, 4);
    Cell indirect = new Cell(.01, 1, 3, 3);
    SplitChoice.Chosen chosen = choice(1, false, direct, indirect).choose();
    assertThat(chosen.exponents()[0]).isZero();
    assertThat(chosen.exponents()[1]).isGreaterThan(0);
    assertThat(chosen.gain()).isGreaterThan(1);
  }

  /** A surface that no pilot pixel has seen is not split, whatever its neighbors do. */
  @Test
  void untrainedCellsAreNotSplit() {
    Cell nothing = new Cell(0, 0, 0, 0);
    Cell direct = new Cell(.1, .01, 1, 4);
    Cell indirect = new Cell(.01, 1, 3, 3);
    int[] exponents = choice(1, false, nothing, direct, indirect).choose().exponents();
    assertThat(exponents[0]).isZero();
    assertThat(exponents[2]).isPositive();
  }

  /**
   * Of pilots of few pixels where two branches are exactly as good as one, few find a gain: one in
   * 100 was measured. The rate counts as 1, so that its noise plays no part.
   */
  @Test
  void noiseIsNoGain() {
    int split = 0;
    for (int trial = 0; trial < 1000; trial++) {
      Cell[] cells = new Cell[6];
      for (int i = 0; i < cells.length; i++) {
        // Two branches are exactly as good as one: (1 + 1) × 6 = (1 + 1 / 2) × 8.
        cells[i] = new Cell(1, 1, 4, 2);
      }
      split += choice(trial, true, 8, .5, cells).choose().bound() > 1 ? 1 : 0;
    }
    // A binomial number of mean 10 reaches 25 with a probability of 0.01 %.
    assertThat(split).isLessThan(25);
  }

  /** One pixel of unsplit paths with a firefly is no gain. */
  @Test
  void fireflyIsNoGain() {
    double[][][][] sums = new double[2][SplitChoice.GROUPS][1][];
    for (double[][][] half : sums) {
      for (double[][] group : half) {
        // Shared errors alone: branches gain nothing.
        group[0] = new double[] {1, 1, 6, 15, .25};
      }
    }
    // Its sample is one of four times as many in the longer mean.
    sums[1][5][0][SplitChoice.ERROR] = 1000;
    sums[1][5][0][SplitChoice.LONG_ERROR] = 1000. / 16;
    assertThat(new SplitChoice(sums).choose().exponents()).containsExactly(0);
  }

  /** A choice for cells is judged by the half that it was not made from. */
  @Test
  void cellsThatTheHalvesDisagreeOnAreNotChosen() {
    double[] good = {100, 1, 6, 15, 25};
    double[] bad = {10, 10, 6, 400, 2.5};
    double[][][][] sums = new double[2][SplitChoice.GROUPS][][];
    for (int group = 0; group < SplitChoice.GROUPS; group++) {
      sums[0][group] = new double[][] {good, bad};
      sums[1][group] = new double[][] {bad, good};
    }
    SplitChoice.Chosen chosen = new SplitChoice(sums).choose();
    assertThat(chosen.exponents()).containsExactly(0, 0);
    assertThat(chosen.gain()).isOne();
  }

  /** Of many cells, some seem to gain by chance; the other half of the pilot does not agree. */
  @Test
  void cellsThatFollowNoiseAreNotChosen() {
    Cell[] cells = new Cell[40];
    // Two branches lose: (1 + 1) × 6 is less than (1 + 1 / 2) × 9.
    Arrays.fill(cells, new Cell(1, 1, 3, 3));
    int split = 0;
    for (int trial = 0; trial < 100; trial++) {
      split += choice(trial, true, 4, 1, cells).choose().bound() > 1 ? 1 : 0;
    }
    assertThat(split).isLessThan(5);
  }

  @Test
  void aLossIsNeverChosen() {
    for (int trial = 0; trial < 200; trial++) {
      assertThat(choice(trial, true, new Cell(1, .5, 2, 3)).choose().exponents())
          .containsExactly(0);
    }
  }

  @Test
  void blackPixelsAreNotSplit() {
    SplitChoice.Chosen chosen = choice(1, false, new Cell(0, 0, 1, 1)).choose();
    assertThat(chosen.exponents()).containsExactly(0);
    assertThat(chosen.gain()).isOne();
  }
}
