package io.github.lumbre.render;

import java.util.function.IntToDoubleFunction;

/** The standard error of a number that is computed from several groups of measurements. */
final class Jackknife {
  /** What stands for no group: the number is computed from all of them. */
  static final int NONE = -1;

  private Jackknife() {}

  /**
   * Returns a number less some standard errors; 0 if it is not finite. The standard error is
   * computed from the values of the number without each group (Efron and Stein 1981, "The Jackknife
   * Estimate of Variance").
   *
   * @param groups number of groups, at least 2
   * @param certainty number of standard errors
   * @param without returns the number without a group, or with all for {@link #NONE}
   */
  static double bound(int groups, double certainty, IntToDoubleFunction without) {
    double[] numbers = new double[groups];
    double mean = 0;
    for (int group = 0; group < groups; group++) {
      numbers[group] = without.applyAsDouble(group);
      mean += numbers[group] / groups;
    }
    double squares = 0;
    for (double number : numbers) {
      squares += (number - mean) * (number - mean);
    }
    double error = Math.sqrt(squares * (groups - 1) / groups);
    double bound = without.applyAsDouble(NONE) - certainty * error;
    return Double.isFinite(bound) ? bound : 0;
  }
}
