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
    return choice(seed, isNoisy, PIXELS, cells);
  }

  private static SplitChoice choice(long seed, boolean isNoisy, int pixels, Cell... cells) {
    SplittableRandom random = new SplittableRandom(seed);
    DoubleUnaryOperator noise = e -> isNoisy ? e * square(normal(random)) : e;
    double[][][][] sums = new double[2][SplitChoice.GROUPS][cells.length][4];
    for (int cell = 0; cell < cells.length; cell++) {
      for (int pixel = 0; pixel < pixels; pixel++) {
        for (int half = 0; half < 2; half++) {
          double[] sum = sums[half][pixel % SplitChoice.GROUPS][cell];
          double shared = noise.applyAsDouble(cells[cell].shared);
          sum[SplitChoice.ERROR] += shared + noise.applyAsDouble(cells[cell].scattered);
          sum[SplitChoice.SPLIT_ERROR] += shared + noise.applyAsDouble(cells[cell].scattered / 4);
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
    for (double ratio : new double[] {.1, 1, 4}) {
      // With a ratio of 4, two branches are best, but they gain 1.11 only.
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
   * Of pilots where two branches are exactly as good as one, few find a gain: about one in 20,
   * because several choices are tried.
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
      split += choice(trial, true, cells).choose().bound() > 1 ? 1 : 0;
    }
    // A binomial number of mean 50 reaches 75 with a probability of 0.03 %.
    assertThat(split).isLessThan(75);
  }

  /** One pixel of unsplit paths with a firefly is no gain. */
  @Test
  void fireflyIsNoGain() {
    double[][][][] sums = new double[2][SplitChoice.GROUPS][1][];
    for (double[][][] half : sums) {
      for (double[][] group : half) {
        // Shared errors alone: branches gain nothing.
        group[0] = new double[] {1, 1, 6, 15};
      }
    }
    sums[1][5][0][SplitChoice.ERROR] = 1000;
    assertThat(new SplitChoice(sums).choose().exponents()).containsExactly(0);
  }

  /** A choice for cells is judged by the half that it was not made from. */
  @Test
  void cellsThatTheHalvesDisagreeOnAreNotChosen() {
    double[] good = {100, 1, 6, 15};
    double[] bad = {10, 10, 6, 400};
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
      split += choice(trial, true, 4, cells).choose().bound() > 1 ? 1 : 0;
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
