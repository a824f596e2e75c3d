package io.github.lumbre.render.denoise;

/**
 * Gives back light that filtering lost: kernels that spare few bright pixels among many dark ones
 * make sparse light too dark. The mean of a neighborhood shows this where it differs from the mean
 * of the result by more than its noise explains; how much of the difference is given back follows
 * from both (James &amp; Stein 1961). Immutable.
 */
final class LostLight {
  private static final int RADIUS = 12;

  /** Differences below two standard deviations are taken for noise. */
  private static final double SQUARED_DEVIATIONS = 4;

  private static final double LEAST = -.9;
  private static final double MOST = 3;
  private static final double TINY = 1e-30;
  private static final double DARK = 1e-9;

  private final Features picture;
  private final float[] filtered;
  private final int width;

  LostLight(Features picture, float[] filtered) {
    this.picture = picture;
    this.filtered = filtered;
    width = picture.width();
  }

  /**
   * Writes pixels of a row of the result with their light given back.
   *
   * @param start the first column
   * @param stop after the last column
   * @param row three values for each pixel of the row
   */
  void write(int y, int start, int stop, float[] row) {
    int first = Math.max(0, y - RADIUS);
    int end = Math.min(picture.height(), y + RADIUS + 1);
    int from = 3 * Math.max(0, start - RADIUS);
    int to = 3 * Math.min(width, stop + RADIUS);
    double[] differences = new double[3 * width];
    double[] variances = new double[3 * width];
    double[] means = new double[3 * width];
    for (int near = first; near < end; near++) {
      addRow(3 * near * width, from, to, differences, variances, means);
    }
    double[] difference = new double[3];
    double[] mean = new double[3];
    for (int x = start; x < stop; x++) {
      int left = Math.max(0, x - RADIUS);
      int right = Math.min(width, x + RADIUS + 1);
      int pixels = (right - left) * (end - first);
      double squares = 0;
      double variance = 0;
      for (int c = 0; c < 3; c++) {
        difference[c] = sum(differences, left, right, c) / pixels;
        mean[c] = sum(means, left, right, c) / pixels;
        squares += difference[c] * difference[c];
        variance += sum(variances, left, right, c) / ((double) pixels * pixels);
      }
      double share = 1 - SQUARED_DEVIATIONS * variance / Math.max(TINY, squares);
      for (int c = 0; c < 3; c++) {
        double gain = Math.max(0, share) * difference[c] / Math.max(DARK, mean[c]);
        double value = filtered[3 * (y * width + x) + c];
        row[3 * x + c] = (float) (value * (1 + Math.max(LEAST, Math.min(MOST, gain))));
      }
    }
  }

  /** Adds values of a row to the sums of its columns; its result begins at an index. */
  private void addRow(
      int row, int from, int to, double[] differences, double[] variances, double[] means) {
    for (int i = from; i < to; i++) {
      double error = picture.noise(row + i);
      differences[i] += picture.light(row + i) - (double) filtered[row + i];
      variances[i] += error * error;
      means[i] += filtered[row + i];
    }
  }

  private static double sum(double[] values, int left, int right, int channel) {
    double sum = 0;
    for (int i = 3 * left + channel; i < 3 * right; i += 3) {
      sum += values[i];
    }
    return sum;
  }
}
