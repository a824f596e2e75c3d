package io.github.lumbre.render;

import io.github.lumbre.image.Rgb;
import java.util.Arrays;
import java.util.List;

/**
 * Errors of pilot pixels, from means of samples with independent random numbers: the squared
 * difference of two means, relative to the squared radiance around the pixel.
 */
final class PilotErrors {
  /** Part of the denominator, as in {@code relmse}. */
  private static final double FLOOR = .01;

  /**
   * The share of the errors that are limited to the largest of the others, so that a few fireflies
   * do not decide.
   */
  private static final double LIMITED = .02;

  private PilotErrors() {}

  /** Returns the error of two means, of a pixel with a square of {@link #squares}. */
  static double of(Rgb a, Rgb b, double square) {
    return square(a.plus(b.times(-1))) / (square + FLOOR);
  }

  /** Returns the largest error that counts in full. */
  static double limit(double[] errors) {
    double[] sorted = errors.clone();
    Arrays.sort(sorted);
    return sorted[(int) ((1 - LIMITED) * (sorted.length - 1))];
  }

  /**
   * Returns the square of the radiance around each pixel. A pixel does not count itself: if it did,
   * a low mean would make its own error large.
   *
   * @param means of each pixel of the grid, row by row
   */
  static double[] squares(PilotGrid pixels, List<Rgb[]> means) {
    double[] squares = new double[means.size()];
    for (int i = 0; i < squares.length; i++) {
      int column = i % pixels.columns();
      int row = i / pixels.columns();
      Rgb sum = Rgb.BLACK;
      int count = 0;
      for (int v = Math.max(0, row - 1); v <= Math.min(pixels.rows() - 1, row + 1); v++) {
        for (int u = Math.max(0, column - 1);
            u <= Math.min(pixels.columns() - 1, column + 1);
            u++) {
          if (u != column || v != row) {
            for (Rgb mean : means.get(v * pixels.columns() + u)) {
              sum = sum.plus(mean);
              count++;
            }
          }
        }
      }
      squares[i] = count == 0 ? 0 : square(sum) / ((double) count * count);
    }
    return squares;
  }

  private static double square(Rgb c) {
    return (c.r() * c.r() + c.g() * c.g() + c.b() * c.b()) / 3;
  }
}
