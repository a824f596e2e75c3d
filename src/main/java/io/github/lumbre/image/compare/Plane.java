package io.github.lumbre.image.compare;

import java.util.Arrays;

/**
 * A raster with one value per pixel, row by row from the top.
 *
 * @param values not copied; the caller must not change them afterwards
 */
record Plane(int width, int height, double[] values) {
  /** A function of a pixel's index. */
  @FunctionalInterface
  interface ByIndex {
    double at(int index);
  }

  /** Returns the plane of a function of the pixels' indices. */
  static Plane of(int width, int height, ByIndex function) {
    double[] values = new double[width * height];
    Arrays.setAll(values, function::at);
    return new Plane(width, height, values);
  }

  /**
   * Returns the convolution with the product of two symmetric or antisymmetric kernels. Beyond the
   * border, the nearest pixel counts.
   *
   * @param across weights along rows, an odd number of them
   * @param down weights along columns, an odd number of them
   */
  Plane convolved(double[] across, double[] down) {
    double[] rows = new double[values.length];
    int reach = across.length / 2;
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        double sum = 0;
        for (int i = -reach; i <= reach; i++) {
          sum += across[i + reach] * values[y * width + clamped(x + i, width)];
        }
        rows[y * width + x] = sum;
      }
    }
    double[] both = new double[values.length];
    reach = down.length / 2;
    for (int y = 0; y < height; y++) {
      for (int i = -reach; i <= reach; i++) {
        int row = clamped(y + i, height) * width;
        for (int x = 0; x < width; x++) {
          both[y * width + x] += down[i + reach] * rows[row + x];
        }
      }
    }
    return new Plane(width, height, both);
  }

  private static int clamped(int index, int count) {
    return Math.max(0, Math.min(index, count - 1));
  }

  double mean() {
    return Arrays.stream(values).sum() / values.length;
  }
}
