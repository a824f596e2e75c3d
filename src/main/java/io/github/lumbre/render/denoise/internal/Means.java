package io.github.lumbre.render.denoise.internal;

/** Means over square neighborhoods of pixels, inside the picture. Immutable. */
final class Means {
  private final int width;
  private final int height;
  private final int near;
  private final int threads;

  /**
   * @param near number of pixels to each side
   */
  Means(int width, int height, int near, int threads) {
    this.width = width;
    this.height = height;
    this.near = near;
    this.threads = threads;
  }

  /** Writes the mean of the values around each pixel. */
  void of(float[] values, float[] means) throws InterruptedException {
    sum(values, means, true);
  }

  /** Writes the sum of the values around each pixel. */
  void sums(float[] values, float[] sums) throws InterruptedException {
    sum(values, sums, false);
  }

  private void sum(float[] values, float[] sums, boolean isMean) throws InterruptedException {
    Rows.compute(
        height,
        threads,
        () -> {
          double[] columns = new double[width];
          return y -> sum(values, y, columns, sums, isMean);
        });
  }

  private void sum(float[] values, int y, double[] columns, float[] sums, boolean isMean) {
    int first = Math.max(0, y - near);
    int last = Math.min(height - 1, y + near);
    for (int x = 0; x < width; x++) {
      double sum = 0;
      for (int row = first; row <= last; row++) {
        sum += values[row * width + x];
      }
      columns[x] = sum;
    }
    for (int x = 0; x < width; x++) {
      int from = Math.max(0, x - near);
      int to = Math.min(width - 1, x + near);
      double sum = 0;
      for (int column = from; column <= to; column++) {
        sum += columns[column];
      }
      int count = (to - from + 1) * (last - first + 1);
      sums[y * width + x] = (float) (isMean ? sum / count : sum);
    }
  }
}
