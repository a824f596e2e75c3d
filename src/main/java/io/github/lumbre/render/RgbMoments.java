package io.github.lumbre.render;

import io.github.lumbre.image.Rgb;

/**
 * Computes the variance of colors per channel, one value at a time (Welford 1962). It averages
 * differences from the first value, because the rounding of a mean far from zero would dominate the
 * error of the variance. Mutable.
 */
final class RgbMoments {
  private int count;
  private Rgb first = Rgb.BLACK;
  private Rgb mean = Rgb.BLACK;
  private Rgb squares = Rgb.BLACK;

  /**
   * Adds a value.
   *
   * @param value finite; may be negative
   */
  void add(Rgb value) {
    first = count == 0 ? value : first;
    count++;
    Rgb shifted = minus(value, first);
    Rgb before = minus(shifted, mean);
    mean = mean.plus(before.times(1.0 / count));
    squares = squares.plus(before.times(minus(shifted, mean)));
  }

  private static Rgb minus(Rgb a, Rgb b) {
    return a.plus(b.times(-1));
  }

  /** Returns the unbiased estimate of the variance; 0 for fewer than two values. */
  Rgb variance() {
    return squares.times(1.0 / Math.max(1, count - 1));
  }
}
