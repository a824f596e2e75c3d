package io.github.lumbre.render;

import io.github.lumbre.math.Elementary;
import java.util.Arrays;

/**
 * Chooses numbers of branches from the errors and the rays of pilot pixels. The model: with n
 * branches, a pixel's squared error is {@code shared + scattered / n}, and its rays grow by the
 * same number for each branch. Both are measured with 1 and with 4 branches.
 *
 * <p>What branches gain is how many more rays unsplit paths need for the same error. As samples are
 * evenly distributed, N times as many of them reduce the squared error by N to the power of a rate
 * that is 1 or more. It is measured, too.
 *
 * <p>The pilot has two halves of other samples. What one half chooses is judged by the other one, so
 * that a choice that follows noise does not seem to gain. Immutable; all sums have a fixed order.
 */
final class SplitChoice {
  /** Logarithm to the base 2 of the largest number of branches, which is measured. */
  static final int MOST = 2;

  /** Number of groups of pilot pixels. The jackknife leaves out one group at a time. */
  static final int GROUPS = 16;

  /**
   * The smallest gain over unsplit paths, in rays. The rays of branches take longer than those of
   * the camera, up to 1.1 times in all.
   */
  private static final double LEAST_GAIN = 1.1;

  /** How many times as many samples of unsplit paths show the rate of their error. */
  static final int LONGER = 4;

  /** How many standard errors a gain must be above 1. */
  private static final double CERTAINTY = 2;

  /** Prices of a ray that are tried, from a 64th to 64 times that of an unsplit path. */
  private static final int PRICES = 49;

  /** The fourth root of 2. */
  private static final double PRICE_RATIO = 1.189207115002721;

  /**
   * Indices of sums: squared error and rays with 1 and with 4 branches, and the error with 1 branch
   * and {@link #LONGER} times as many samples.
   */
  static final int ERROR = 0;

  static final int SPLIT_ERROR = 1;
  static final int RAYS = 2;
  static final int SPLIT_RAYS = 3;
  static final int LONG_ERROR = 4;
  static final int KINDS = 5;

  /** Sums by half, group, cell and kind. */
  private final double[][][][] sums;

  private final int cells;

  /**
   * Creates a choice.
   *
   * @param sums by half of the pilot (2), group ({@link #GROUPS}), cell and kind ({@link #KINDS}); not copied
   */
  SplitChoice(double[][][][] sums) {
    this.sums = sums;
    cells = sums[0][0].length;
  }

  /**
   * What is chosen.
   *
   * @param exponents logarithm to the base 2 of the number of branches, by cell
   * @param gain rays of unsplit paths relative to those of split ones, for the same squared error
   * @param bound the gain less {@link #CERTAINTY} standard errors
   */
  record Chosen(int[] exponents, double gain, double bound) {}

  /**
   * Returns the choice. Each step to more branches or to cells must gain for certain, and all must
   * gain {@link #LEAST_GAIN}.
   */
  Chosen choose() {
    Candidate whole = Candidate.same(0, cells);
    Candidate best = whole;
    for (int exponent = 1; exponent <= MOST; exponent++) {
      best = better(best, Candidate.same(exponent, cells));
    }
    int[] all = bestFor(total(both()));
    Candidate own = new Candidate(all, bestFor(total(sums[1])), bestFor(total(sums[0])));
    best = better(best, own);
    return best == whole || gain(best, whole, Jackknife.NONE) < LEAST_GAIN
        ? new Chosen(whole.chosen, 1, 1)
        : new Chosen(best.chosen, gain(best, whole, Jackknife.NONE), bound(best, whole));
  }

  /**
   * Numbers of branches by cell that may be chosen.
   *
   * @param inFirst the numbers that the second half of the pilot chooses, judged by the first half
   * @param inSecond the numbers that the first half chooses, judged by the second half
   */
  private record Candidate(int[] chosen, int[] inFirst, int[] inSecond) {
    static Candidate same(int exponent, int cells) {
      int[] same = new int[cells];
      Arrays.fill(same, exponent);
      return new Candidate(same, same, same);
    }
  }

  private Candidate better(Candidate best, Candidate other) {
    return bound(other, best) > 1 ? other : best;
  }

  /**
   * Returns the gain of a candidate over another one, less {@link #CERTAINTY} standard errors; 0 if
   * there is nothing to compare.
   */
  private double bound(Candidate candidate, Candidate other) {
    return Jackknife.bound(GROUPS, CERTAINTY, group -> gain(candidate, other, group));
  }

  /** Returns the gain of a candidate over another one, without the pixels of a group. */
  private double gain(Candidate candidate, Candidate other, int without) {
    double[][] first = total(sums[0], without);
    double[][] second = total(sums[1], without);
    double rate = rate(first, second);
    return cost(other, first, second, rate) / cost(candidate, first, second, rate);
  }

  /** Returns a number that is proportional to the rays of a candidate for a given error. */
  private static double cost(
      Candidate candidate, double[][] first, double[][] second, double rate) {
    double error = sum(first, candidate.inFirst, true) + sum(second, candidate.inSecond, true);
    double rays = sum(first, candidate.inFirst, false) + sum(second, candidate.inSecond, false);
    return Elementary.pow(error, 1 / rate) * rays;
  }

  /** Returns the power of the number of samples by which the squared error of unsplit paths falls. */
  private static double rate(double[][]... totals) {
    double error = 0;
    double longError = 0;
    for (double[][] total : totals) {
      for (double[] cell : total) {
        error += cell[ERROR];
        longError += cell[LONG_ERROR];
      }
    }
    return Math.max(1, Elementary.log(error / longError) / Elementary.log(LONGER));
  }

  private static double sum(double[][] totals, int[] exponents, boolean isError) {
    double sum = 0;
    for (int cell = 0; cell < totals.length; cell++) {
      sum += isError ? error(totals[cell], exponents[cell]) : rays(totals[cell], exponents[cell]);
    }
    return sum;
  }

  /** Returns the error with 2^exponent branches by the model. */
  private static double error(double[] cell, int exponent) {
    double scattered = (cell[ERROR] - cell[SPLIT_ERROR]) * 4 / 3;
    return cell[ERROR] - scattered + scattered / (1 << exponent);
  }

  private static double rays(double[] cell, int exponent) {
    return cell[RAYS] + (cell[SPLIT_RAYS] - cell[RAYS]) / 3 * ((1 << exponent) - 1);
  }

  private double[][][] both() {
    double[][][] both = new double[2 * GROUPS][][];
    System.arraycopy(sums[0], 0, both, 0, GROUPS);
    System.arraycopy(sums[1], 0, both, GROUPS, GROUPS);
    return both;
  }

  private static double[][] total(double[][][] groups) {
    return total(groups, Jackknife.NONE);
  }

  private static double[][] total(double[][][] groups, int without) {
    double[][] total = new double[groups[0].length][KINDS];
    for (int group = 0; group < groups.length; group++) {
      for (int cell = 0; group != without && cell < total.length; cell++) {
        for (int kind = 0; kind < KINDS; kind++) {
          total[cell][kind] += groups[group][cell][kind];
        }
      }
    }
    return total;
  }

  /**
   * Returns the numbers of branches that need the fewest rays for a given error. For a given price
   * of a ray, each cell has its own best number; the best of several prices is taken.
   */
  private static int[] bestFor(double[][] totals) {
    double power = 1 / rate(totals);
    int[] best = new int[totals.length];
    double least = Elementary.pow(sum(totals, best, true), power) * sum(totals, best, false);
    double usual = sum(totals, best, true) / sum(totals, best, false);
    double price = usual / 64;
    for (int step = 0; step < PRICES; step++, price *= PRICE_RATIO) {
      int[] tried = new int[totals.length];
      for (int cell = 0; cell < totals.length; cell++) {
        tried[cell] = bestFor(totals[cell], price);
      }
      double cost = Elementary.pow(sum(totals, tried, true), power) * sum(totals, tried, false);
      if (cost < least) {
        least = cost;
        best = tried;
      }
    }
    return best;
  }

  private static int bestFor(double[] cell, double price) {
    int best = 0;
    for (int exponent = 1; exponent <= MOST; exponent++) {
      if (total(cell, exponent, price) < total(cell, best, price)) {
        best = exponent;
      }
    }
    return best;
  }

  private static double total(double[] cell, int exponent, double price) {
    return error(cell, exponent) + price * rays(cell, exponent);
  }
}
