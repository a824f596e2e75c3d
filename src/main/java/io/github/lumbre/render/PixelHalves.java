package io.github.lumbre.render;

import io.github.lumbre.image.Rgb;

/**
 * The samples of a pixel in two parts, from whose difference its noise can be told. The first part
 * is the largest power of two below the number of all, so that it is a stratified whole, and if
 * their number is a power of two, so is the second.
 *
 * @param firstCount samples in the first part, at least 1
 * @param first their mean, to about five digits of its largest component
 * @param secondCount samples in the second part, 1 to {@code firstCount}
 * @param second their mean; rounding of the first may make it slightly negative
 */
public record PixelHalves(int firstCount, Rgb first, int secondCount, Rgb second) {
  /** Keeps dark pixels from counting for all; in units of squared linear light. */
  public static final double FLOOR = .01;

  /**
   * Returns an estimate of the relative squared error of the mean of all, the mean over channels.
   *
   * <p>For halves of n1 and n2 samples with means m1 and m2, (m1 − m2)² n1 n2 / (n1 + n2)²
   * estimates the variance of the mean of all. It is unbiased for independent samples, and too high
   * for those of a scrambled net, whose halves make up for each other's errors (their covariance is
   * negative: Owen 1997, "Monte Carlo Variance of Scrambled Net Quadrature"): by (1 − ρ)/(1 + ρ), ρ
   * being their correlation, whatever the number of samples. Fixed batches would be off by a factor
   * that grows with it.
   *
   * <p>The reference's square, for the relative error, is m1 m2 without noise on average, whereas
   * m² would hide the error of bright spots in their own brightness.
   */
  public double relativeSquaredError() {
    return mean(
        relative(first.r(), second.r()),
        relative(first.g(), second.g()),
        relative(first.b(), second.b()));
  }

  /**
   * Returns an estimate that is too high rather than too low: for few samples, where a bright spot
   * in one half makes m1 m2 large just when m1 − m2 is, which hides its error. The square of the
   * reference is taken as m √(m1 m2), m being the smaller of the two.
   */
  public double cautiousSquaredError() {
    return mean(
        cautious(first.r(), second.r()),
        cautious(first.g(), second.g()),
        cautious(first.b(), second.b()));
  }

  private double mean(double r, double g, double b) {
    double all = (double) firstCount + secondCount;
    double factor = firstCount / all * (secondCount / all);
    return factor * (r + g + b) / 3;
  }

  private static double relative(double a, double b) {
    return (a - b) * (a - b) / (Math.max(0, a * b) + FLOOR);
  }

  private static double cautious(double a, double b) {
    double smaller = Math.max(0, Math.min(a, b));
    return (a - b) * (a - b) / (smaller * Math.sqrt(Math.max(0, a * b)) + FLOOR);
  }
}
