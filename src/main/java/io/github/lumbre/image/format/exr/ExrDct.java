package io.github.lumbre.image.format.exr;

import java.math.BigDecimal;
import java.math.MathContext;

/**
 * The inverse cosine transform of squares of 8x8 numbers (Ahmed, Natarajan and Rao 1974), in
 * floats. Weights and the order of additions are those of OpenEXR on x86-64 with AVX, so that
 * values are rounded alike, on every machine. Holds a square; mutable.
 */
final class ExrDct {
  static final int SIDE = 8;
  static final int SIZE = SIDE * SIDE;
  private static final int HALF = SIDE / 2;

  /** OpenEXR's weights are cosines with this value of pi, rounded to so many digits. */
  private static final double PI = 3.14159;

  private static final MathContext DIGITS = new MathContext(7);

  /** The places of coefficients in a square, from low to high frequencies by diagonals. */
  private static final int[] ZIGZAG = new int[SIZE];

  /** For each of the first four places in a line, the weights of the eight coefficients. */
  private static final float[] WEIGHTS = new float[HALF * SIDE];

  static {
    int i = 0;
    for (int sum = 0; sum < 2 * SIDE - 1; sum++) {
      for (int k = Math.max(0, sum - SIDE + 1); k <= Math.min(sum, SIDE - 1); k++) {
        // Diagonals run up and down in turns.
        int row = sum % 2 == 0 ? sum - k : k;
        ZIGZAG[i++] = SIDE * row + sum - row;
      }
    }
    for (int x = 0; x < HALF; x++) {
      for (int k = 0; k < SIDE; k++) {
        WEIGHTS[SIDE * x + k] = k == 0 ? halfCosine(4) : halfCosine((2 * x + 1) * k);
      }
    }
  }

  /** The square: coefficients line by line, then values. */
  final float[] values = new float[SIZE];

  private final float[] lines = new float[SIZE];

  /** Returns the number of squares that cover a line of pixels. */
  static int squares(int pixels) {
    return (pixels + SIDE - 1) / SIDE;
  }

  /** Returns half the cosine of a number of sixteenths of pi. */
  private static float halfCosine(int sixteenths) {
    int turned = Math.abs(Math.floorMod(sixteenths + 16, 32) - 16);
    int acute = Math.min(turned, 16 - turned);
    float rounded = new BigDecimal(.5 * StrictMath.cos(acute * PI / 16)).round(DIGITS).floatValue();
    return acute == turned ? rounded : -rounded;
  }

  /** Sets a coefficient by its number in the order of frequencies. */
  void set(int number, float coefficient) {
    values[ZIGZAG[number]] = coefficient;
  }

  /** Replaces coefficients by values. */
  void transform() {
    for (int row = 0; row < SIDE; row++) {
      transformRow(SIDE * row);
    }
    for (int column = 0; column < SIDE; column++) {
      transformColumn(column);
    }
  }

  private void transformRow(int at) {
    float[] v = values;
    for (int x = 0; x < HALF; x++) {
      int w = SIDE * x;
      float even =
          (WEIGHTS[w] * v[at] + WEIGHTS[w + 2] * v[at + 2])
              + (WEIGHTS[w + 4] * v[at + 4] + WEIGHTS[w + 6] * v[at + 6]);
      float odd =
          (WEIGHTS[w + 1] * v[at + 1] + WEIGHTS[w + 3] * v[at + 3])
              + (WEIGHTS[w + 5] * v[at + 5] + WEIGHTS[w + 7] * v[at + 7]);
      lines[at + x] = even + odd;
      lines[at + SIDE - 1 - x] = even - odd;
    }
  }

  private void transformColumn(int at) {
    float[] v = lines;
    for (int y = 0; y < HALF; y++) {
      int w = SIDE * y;
      float even =
          (WEIGHTS[w] * v[at] + WEIGHTS[w + 4] * v[at + 32])
              + (WEIGHTS[w + 2] * v[at + 16] + WEIGHTS[w + 6] * v[at + 48]);
      float a = WEIGHTS[w + 1] * v[at + 8];
      float b = WEIGHTS[w + 3] * v[at + 24];
      float c = WEIGHTS[w + 5] * v[at + 40];
      float d = WEIGHTS[w + 7] * v[at + 56];
      float odd =
          switch (y) {
            case 0 -> (a + b) + (c + d);
            case 1 -> (b + c) + a + d;
            case 2 -> a + b + c + d;
            default -> (a + c) + (b + d);
          };
      values[at + SIDE * y] = even + odd;
      values[at + SIDE * (SIDE - 1 - y)] = even - odd;
    }
  }
}
