package io.github.lumbre.render;

import io.github.lumbre.image.Rgb;

/**
 * The samples of a pixel in two parts, whose difference gives an estimate of the pixel's noise. The
 * size of the first part is the largest power of two below the number of samples, so it is a
 * complete stratified set. If the number of samples is a power of two, so is the second part.
 *
 * @param firstCount the number of samples in the first part, at least 1
 * @param first the mean of the first part, to about five digits of its largest component
 * @param secondCount the number of samples in the second part, 1 to {@code firstCount}
 * @param second the mean of the second part; the rounding of {@code first} can make it slightly
 *     negative
 */
public record PixelHalves(int firstCount, Rgb first, int secondCount, Rgb second) {
  /**
   * A summand of the denominator that limits the weight of dark pixels; in units of squared
   * radiance.
   */
  public static final double FLOOR = .01;

  /**
   * Returns an estimate of the relative squared error of the mean of all samples, averaged over the
   * channels.
   *
   * <p>For halves of n1 and n2 samples with means m1 and m2, (m1 − m2)² n1 n2 / (n1 + n2)²
   * estimates the variance of the mean of all samples. It is unbiased for independent samples. For
   * a scrambled net, it is too high by the factor (1 − ρ)/(1 + ρ), where ρ is the correlation of
   * the halves. This factor does not depend on the number of samples. Their covariance is negative,
   * so their errors partly cancel (Owen 1997, "Monte Carlo Variance of Scrambled Net Quadrature").
   * With fixed batches, the factor would grow with the number of samples.
   *
   * <p>The relative error divides by m1 m2, which estimates the squared true value. The squared
   * mean would hide the error of bright spots, because it contains their own brightness.
   */
  public double relativeSquaredError() {
    return mean(
        relative(first.r(), second.r()),
        relative(first.g(), second.g()),
        relative(first.b(), second.b()));
  }

  /**
   * Returns a conservative estimate of the same error, for few samples. There, a bright spot in one
   * half makes both m1 m2 and m1 − m2 large, which hides its error. This estimate divides by m √(m1
   * m2) instead, where m is the smaller of the two means.
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
