package io.github.lumbre.image.internal;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * The colors that numbers of a file stand for: the CIE x and y of its red, green, blue and white.
 * Matrices have nine numbers, row by row. Stateless.
 */
public final class Primaries {
  /** ITU-R BT.709, which files without the attribute have. */
  private static final double[] REC709 = {.64, .33, .3, .6, .15, .06, .3127, .329};

  /** The largest difference of coordinates that are the same, but for their decimals. */
  private static final double SAME = 1e-3;

  /** Bradford's responses of the eye to XYZ (Lam 1985; ICC.1:2022, annex E). */
  private static final double[] BRADFORD = {
    .8951, .2664, -.1614, -.7502, 1.7135, .0367, .0389, -.0685, 1.0296
  };

  private Primaries() {}

  /**
   * Returns the matrix from a file's colors to those of BT.709, which keeps white; empty if they
   * are the same, or the numbers do not describe colors.
   *
   * @param own x and y of red, green, blue and white
   */
  public static Optional<double[]> toRec709(double... own) {
    if (own.length != REC709.length || areSame(own, REC709)) {
      return Optional.empty();
    }
    double[] adapted = times(adaptation(white(own), white(REC709)), toXyz(own));
    double[] matrix = times(inverse(toXyz(REC709)), adapted);
    return Arrays.stream(matrix).allMatch(Double::isFinite)
        ? Optional.of(matrix)
        : Optional.empty();
  }

  /** Returns whether coordinates are the same, but for their decimals. */
  public static boolean areSame(double[] some, double... others) {
    return IntStream.range(0, others.length).allMatch(i -> Math.abs(some[i] - others[i]) <= SAME);
  }

  /**
   * Converts colors in place.
   *
   * @param values red, green and blue of each pixel, which further values may follow
   * @param stride number of values of each pixel
   */
  public static void convert(float[] values, int stride, double... m) {
    for (int i = 0; i < values.length; i += stride) {
      double r = values[i];
      double g = values[i + 1];
      double b = values[i + 2];
      for (int row = 0; row < 3; row++) {
        values[i + row] = (float) (m[3 * row] * r + m[3 * row + 1] * g + m[3 * row + 2] * b);
      }
    }
  }

  /** Returns the XYZ of a white with Y = 1. */
  private static double[] white(double... chromaticities) {
    double x = chromaticities[6];
    double y = chromaticities[7];
    return new double[] {x / y, 1, (1 - x - y) / y};
  }

  /** Returns the matrix from RGB to XYZ: its columns are the primaries, which add up to white. */
  private static double[] toXyz(double... chromaticities) {
    double[] primaries = new double[9];
    for (int i = 0; i < 3; i++) {
      double x = chromaticities[2 * i];
      double y = chromaticities[2 * i + 1];
      primaries[i] = x;
      primaries[3 + i] = y;
      primaries[6 + i] = 1 - x - y;
    }
    return times(primaries, diagonal(apply(inverse(primaries), white(chromaticities))));
  }

  /** Returns the matrix that takes colors under one white to those under another. */
  private static double[] adaptation(double[] from, double[] to) {
    double[] before = apply(BRADFORD, from);
    double[] after = apply(BRADFORD, to);
    double[] gains = {after[0] / before[0], after[1] / before[1], after[2] / before[2]};
    return times(inverse(BRADFORD), times(diagonal(gains), BRADFORD));
  }

  private static double[] diagonal(double... d) {
    return new double[] {d[0], 0, 0, 0, d[1], 0, 0, 0, d[2]};
  }

  private static double[] apply(double[] m, double... v) {
    double[] result = new double[3];
    for (int i = 0; i < 3; i++) {
      result[i] = m[3 * i] * v[0] + m[3 * i + 1] * v[1] + m[3 * i + 2] * v[2];
    }
    return result;
  }

  private static double[] times(double[] a, double[] b) {
    double[] product = new double[9];
    for (int i = 0; i < 9; i++) {
      int row = 3 * (i / 3);
      int column = i % 3;
      product[i] = a[row] * b[column] + a[row + 1] * b[3 + column] + a[row + 2] * b[6 + column];
    }
    return product;
  }

  /** Returns the inverse; not finite if there is none. */
  private static double[] inverse(double... m) {
    double[] inverse = new double[9];
    for (int i = 0; i < 9; i++) {
      // The cofactor of the transposed element, by cyclic indices.
      int row = i % 3;
      int column = i / 3;
      int r1 = 3 * ((row + 1) % 3);
      int r2 = 3 * ((row + 2) % 3);
      int c1 = (column + 1) % 3;
      int c2 = (column + 2) % 3;
      inverse[i] = m[r1 + c1] * m[r2 + c2] - m[r1 + c2] * m[r2 + c1];
    }
    double determinant = m[0] * inverse[0] + m[1] * inverse[3] + m[2] * inverse[6];
    return Arrays.stream(inverse).map(cofactor -> cofactor / determinant).toArray();
  }
}
