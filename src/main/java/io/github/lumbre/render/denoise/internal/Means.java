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

  /**
   * Writes the mean of the values around each pixel, of those pixels that count.
   *
   * @param counts 1 for each pixel that counts, otherwise 0, as its value is
   * @param means receives 0 where no pixel counts
   */
  void of(float[] values, float[] counts, float[] means) throws InterruptedException {
    Rows.compute(
        height,
        threads,
        () -> {
          double[] columns = new double[width];
          double[] sums = new double[width];
          double[] numbers = new double[width];
          return y -> {
            sum(values, y, columns, sums);
            sum(counts, y, columns, numbers);
            for (int x = 0; x < width; x++) {
              means[y * width + x] = numbers[x] > 0 ? (float) (sums[x] / numbers[x]) : 0;
            }
          };
        });
  }

  /** Writes the sums of the values around the pixels of a row. */
  private void sum(float[] values, int y, double[] columns, double[] sums) {
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
      sums[x] = sum;
    }
  }
}
