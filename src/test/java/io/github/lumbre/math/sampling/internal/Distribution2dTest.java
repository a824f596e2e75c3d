package io.github.lumbre.math.sampling.internal;

import static io.github.lumbre.testing.Draws.inSquare;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Point2;
import io.github.lumbre.testing.ChiSquare;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the sampling of piecewise constant densities on the unit square. */
class Distribution2dTest {
  private static final double LAST = 1 - 0x1p-53;

  private final SplittableRandom random = new SplittableRandom(10);

  private double[][] weights(int rows, int columns) {
    double[][] weights = new double[rows][columns];
    for (double[] row : weights) {
      for (int column = 0; column < columns; column++) {
        row[column] = Math.max(0, random.nextDouble(-.3, 1));
      }
    }
    return weights;
  }

  @Test
  void pointsFollowTheWeights() {
    int rows = 13;
    int columns = 7;
    double[][] weights = weights(rows, columns);
    Distribution2d distribution = new Distribution2d(weights);
    int n = 200_000;
    // Count in quarters of each cell, to check the distribution inside cells.
    long[] counts = new long[4 * rows * columns];
    double[] expected = new double[counts.length];
    double total = 0;
    for (int i = 0; i < n; i++) {
      Point2 p = distribution.sample(inSquare(random)).point();
      counts[(int) (p.y() * 2 * rows) * 2 * columns + (int) (p.x() * 2 * columns)]++;
    }
    for (int i = 0; i < counts.length; i++) {
      expected[i] = weights[i / (2 * columns) / 2][i % (2 * columns) / 2];
      total += expected[i];
    }
    for (int i = 0; i < counts.length; i++) {
      expected[i] *= n / total;
    }
    assertThat(ChiSquare.of(counts, expected).passes()).isTrue();
  }

  @Test
  void densityIsThatOfTheDrawnPointAndIntegratesToOne() {
    Distribution2d distribution = new Distribution2d(weights(49, 98));
    for (int i = 0; i < 100_000; i++) {
      Distribution2d.Sample sample = distribution.sample(inSquare(random));
      assertThat(distribution.pdf(sample.point())).isEqualTo(sample.pdf());
    }
    double integral = 0;
    for (int row = 0; row < 49; row++) {
      for (int column = 0; column < 98; column++) {
        integral += distribution.pdf(new Point2((column + .5) / 98, (row + .5) / 49));
      }
    }
    assertThat(integral / (49 * 98)).isCloseTo(1, within(1e-13));
  }

  /**
   * The point's own cell differs where 7/49·49 rounds below 7, or where 6.99…/49 rounds up to 7/49.
   */
  @Test
  void singleCellIsFoundFromAnyNumbersWithItsDensity() {
    for (int columns : new int[] {1, 3, 49, 1000, 16383}) {
      for (int bright : new int[] {0, columns / 7, columns - 1}) {
        double[][] weights = new double[3][columns];
        weights[2][bright] = 1e-300;
        Distribution2d distribution = new Distribution2d(weights);
        for (double u : new double[] {0, .5, 1 - 0x1p-32, LAST}) {
          Distribution2d.Sample sample = distribution.sample(new Point2(u, u));
          assertThat(sample.pdf()).isCloseTo(3.0 * columns, within(1e-9));
          assertThat(sample.point().x()).isBetween(0.0, LAST);
          assertThat(sample.point().y()).isBetween(0.0, LAST);
          double inside = sample.point().x() * columns - bright;
          assertThat(inside).isBetween(-1e-11, 1 + 1e-11);
        }
      }
    }
  }

  @Test
  void extremeWeightsKeepTheirProportions() {
    for (double scale : new double[] {1e-300, 1e300, 1e308}) {
      Distribution2d distribution =
          new Distribution2d(new double[][] {{scale, 0}, {scale, scale / 2}, {0, 0}});
      assertThat(distribution.pdf(new Point2(.2, .1))).isCloseTo(2.4, within(1e-14));
      assertThat(distribution.pdf(new Point2(.7, .5))).isCloseTo(1.2, within(1e-14));
      assertThat(distribution.pdf(new Point2(.2, .9))).isZero();
    }
  }

  /** Rows of large grids are prepared by several threads. */
  @ParameterizedTest
  @ValueSource(ints = {256, 257, 3000})
  void everyRowHasTheProbabilitiesOfItsWeights(int rows) {
    double[][] weights = weights(rows, 7);
    Distribution1d means =
        new Distribution1d(
            Arrays.stream(weights).mapToDouble(row -> new Distribution1d(row).mean()).toArray());
    Distribution2d distribution = new Distribution2d(weights);
    for (int row = 0; row < rows; row++) {
      Distribution1d cells = new Distribution1d(weights[row]);
      for (int column = 0; column < 7; column++) {
        assertThat(distribution.probability(row, column))
            .isEqualTo(means.probability(row) * cells.probability(column));
      }
    }
  }

  @Test
  void withoutAnyWeightTheDensityIsOne() {
    Distribution2d distribution = new Distribution2d(new double[5][4]);
    assertThat(distribution.pdf(inSquare(random))).isCloseTo(1, within(1e-15));
    assertThat(distribution.sample(inSquare(random)).pdf()).isCloseTo(1, within(1e-15));
  }

  @Test
  void farEdgesOfTheSquareBelongToTheLastCells() {
    Distribution2d distribution = new Distribution2d(new double[][] {{1, 2, 3}, {4, 5, 6}});
    assertThat(distribution.pdf(new Point2(1, 1)))
        .isEqualTo(distribution.pdf(new Point2(LAST, LAST)));
    assertThat(distribution.pdf(new Point2(1, 0))).isEqualTo(distribution.pdf(new Point2(LAST, 0)));
    assertThat(distribution.pdf(new Point2(0, 1))).isEqualTo(distribution.pdf(new Point2(0, LAST)));
  }
}
