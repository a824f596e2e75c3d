package io.github.lumbre.render.denoise.internal;

import java.util.Arrays;

/**
 * Sums over square neighborhoods of pixels, inside the picture, row by row. Loops are in the order
 * that the compiler turns into vector instructions. Mutable; each thread has one.
 */
final class Sums {
  private final int width;
  private final int height;
  private final int near;

  /** Sums of columns, with zeros on both sides. */
  private final float[] columns;

  /**
   * @param near number of pixels to each side
   */
  Sums(int width, int height, int near) {
    this.width = width;
    this.height = height;
    this.near = near;
    columns = new float[width + 2 * near];
  }

  /**
   * Writes the sums around the pixels of a row.
   *
   * @param sums receives one value for each pixel of the row
   */
  void of(float[] values, int y, float[] sums) {
    Arrays.fill(columns, 0);
    for (int row = Math.max(0, y - near); row <= Math.min(height - 1, y + near); row++) {
      int first = row * width;
      for (int x = 0; x < width; x++) {
        columns[near + x] += values[first + x];
      }
    }
    Arrays.fill(sums, 0);
    for (int column = 0; column <= 2 * near; column++) {
      for (int x = 0; x < width; x++) {
        sums[x] += columns[column + x];
      }
    }
  }
}
