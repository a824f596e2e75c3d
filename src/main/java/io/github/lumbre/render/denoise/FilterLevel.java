package io.github.lumbre.render.denoise;

/**
 * A level of a tile: its light before and after the predicted kernels. Planes are plain and divided
 * light, and maybe the same of the noise.
 */
final class FilterLevel {
  /** Fills rows of light. */
  interface Light {
    /** Writes pixels of a row, those from x on; either may be outside the tile. */
    void write(int x, int y, float[][] rows, int count);
  }

  final int width;
  final int height;

  /** What is left of the light at this level; then the result. */
  final float[][] filtered;

  /** How far the coarser level replaces the low frequencies. */
  final float[] share;

  /** At full size: the share of divided light in the result. */
  final float[] mix;

  /** The weight of each pixel among those that are pooled. */
  final float[] weight;

  /** The light before filtering; none at full size, where it follows from the picture. */
  final float[][] light;

  FilterLevel(int level, int width, int height, int planes) {
    this.width = width;
    this.height = height;
    int pixels = Math.multiplyExact(width, height);
    filtered = new float[planes][pixels];
    share = new float[pixels];
    mix = new float[level == 0 ? pixels : 0];
    weight = new float[level == 0 ? 0 : pixels];
    light = new float[level == 0 ? 0 : planes][pixels];
  }

  /** Returns the light of this level, as it was pooled; borders are repeated. */
  Light light() {
    return (x, y, rows, count) -> {
      int row = Math.max(0, Math.min(height - 1, y)) * width;
      for (int c = 0; c < rows.length; c++) {
        for (int i = 0; i < count; i++) {
          rows[c][i] = light[c][row + Math.max(0, Math.min(width - 1, x + i))];
        }
      }
    };
  }

  /**
   * Replaces the low frequencies of rows of a result by the rows of the next coarser level.
   *
   * @param change the coarser level minus this one pooled, by plane
   */
  void add(float[][] change, int first, int end) {
    int half = width / 2;
    for (int y = first; y < end; y++) {
      int above = Math.max(0, (y - 1) >> 1) * half;
      int below = Math.min(height / 2 - 1, (y + 1) >> 1) * half;
      float upper = y % 2 == 0 ? .25f : .75f;
      for (int c = 0; c < filtered.length; c++) {
        for (int x = 0; x < width; x++) {
          int left = Math.max(0, (x - 1) >> 1);
          int right = Math.min(half - 1, (x + 1) >> 1);
          float near = x % 2 == 0 ? .25f : .75f;
          float top = near * change[c][above + left] + (1 - near) * change[c][above + right];
          float bottom = near * change[c][below + left] + (1 - near) * change[c][below + right];
          filtered[c][y * width + x] += share[y * width + x] * (upper * top + (1 - upper) * bottom);
        }
      }
    }
  }

  /** Writes rows of this result minus the means of 2x2 pixels of a finer one. */
  void subtract(FilterLevel finer, float[][] change, int first, int end) {
    for (int c = 0; c < filtered.length; c++) {
      float[] fine = finer.filtered[c];
      for (int i = first * width; i < end * width; i++) {
        int at = i / width * 2 * finer.width + i % width * 2;
        float sum = fine[at] + fine[at + 1] + (fine[at + finer.width] + fine[at + finer.width + 1]);
        change[c][i] = filtered[c][i] - .25f * sum;
      }
    }
  }
}
