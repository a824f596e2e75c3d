package io.github.lumbre.render.denoise;

/** Replaces pixels that are not finite, which files of other programs can have. */
final class Repair {
  private static final int CHANNELS = 3;

  private Repair() {}

  /**
   * Replaces each pixel with a value that is not finite by the mean of its nearest finite
   * neighbors, and negative values by 0.
   *
   * @param light three values for each pixel; changed
   * @return number of replaced pixels
   * @throws IllegalArgumentException if no pixel is finite
   */
  static int replaceNonFinite(float[] light, int width, int height) {
    int left = 0;
    for (int i = 0; i < width * height; i++) {
      if (!isFinite(light, i)) {
        left++;
      }
    }
    int replaced = left;
    if (left == width * height) {
      throw new IllegalArgumentException(
          "expected a picture with finite pixels, found only NaN and infinite ones");
    }
    while (left != 0) {
      left -= grow(light, width, height);
    }
    for (int i = 0; i < light.length; i++) {
      light[i] = Math.max(0, light[i]);
    }
    return replaced;
  }

  private static boolean isFinite(float[] light, int pixel) {
    return Float.isFinite(light[CHANNELS * pixel])
        && Float.isFinite(light[CHANNELS * pixel + 1])
        && Float.isFinite(light[CHANNELS * pixel + 2]);
  }

  /** Replaces the pixels that have finite neighbors, and returns their number. */
  private static int grow(float[] light, int width, int height) {
    float[] before = light.clone();
    int grown = 0;
    for (int i = 0; i < width * height; i++) {
      if (!isFinite(before, i) && replace(before, light, i, width, height)) {
        grown++;
      }
    }
    return grown;
  }

  private static boolean replace(float[] before, float[] light, int pixel, int width, int height) {
    double[] sum = new double[CHANNELS];
    int count = 0;
    for (int y = Math.max(0, pixel / width - 1);
        y <= Math.min(height - 1, pixel / width + 1);
        y++) {
      for (int x = Math.max(0, pixel % width - 1);
          x <= Math.min(width - 1, pixel % width + 1);
          x++) {
        int near = y * width + x;
        if (isFinite(before, near)) {
          count++;
          for (int c = 0; c < CHANNELS; c++) {
            sum[c] += before[CHANNELS * near + c];
          }
        }
      }
    }
    for (int c = 0; c < CHANNELS && count != 0; c++) {
      light[CHANNELS * pixel + c] = (float) (sum[c] / count);
    }
    return count != 0;
  }
}
