package io.github.lumbre.render;

import io.github.lumbre.image.Rgb;

/**
 * Mean and variance of colours, by channel, updated one by one (Welford 1962). What is averaged is
 * the difference from the first, since of a mean far from zero the rounding would be the variance's
 * error. Mutable.
 */
final class RgbMoments {
  private int count;
  private Rgb first = Rgb.BLACK;
  private Rgb mean = Rgb.BLACK;
  private Rgb squares = Rgb.BLACK;

  /**
   * @param value any finite numbers
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
