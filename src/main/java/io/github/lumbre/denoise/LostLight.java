package io.github.lumbre.denoise;

import java.util.Arrays;

/**
 * Gives back light that filtering lost: kernels that spare few bright pixels among many dark ones
 * make sparse light too dark. The mean of a neighborhood shows this where it differs from the mean
 * of the result by more than its noise explains; how much of the difference is given back follows
 * from both (James &amp; Stein 1961). Mutable; rows that follow each other share work.
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
  private final float[] noise;
  private final int width;

  /** The light of the rows of a neighborhood, each at its number modulo their count. */
  private final float[][] lights;

  /** The numbers of these rows; -1 for none. */
  private final int[] lightRows = new int[2 * RADIUS + 1];

  LostLight(Features picture, float[] noise, float[] filtered) {
    this.picture = picture;
    this.noise = noise;
    this.filtered = filtered;
    width = picture.width();
    lights = new float[lightRows.length][3 * width];
    Arrays.fill(lightRows, -1);
  }

  /** Writes a row of the result with its light given back, three values for each pixel. */
  void write(int y, float[] row) {
    int first = Math.max(0, y - RADIUS);
    int end = Math.min(picture.height(), y + RADIUS + 1);
    double[] differences = new double[3 * width];
    double[] variances = new double[3 * width];
    double[] means = new double[3 * width];
    for (int near = first; near < end; near++) {
      addRow(light(near), 3 * near * width, differences, variances, means);
    }
    double[] difference = new double[3];
    double[] mean = new double[3];
    for (int x = 0; x < width; x++) {
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

  /** Returns the light of a row of the picture. */
  private float[] light(int y) {
    int slot = y % lights.length;
    if (lightRows[slot] != y) {
      lightRows[slot] = y;
      for (int i = 0; i < 3 * width; i++) {
        lights[slot][i] = picture.light(3 * y * width + i);
      }
    }
    return lights[slot];
  }

  /** Adds a row to the sums of its columns; its noise and its result begin at an index. */
  private void addRow(
      float[] light, int start, double[] differences, double[] variances, double[] means) {
    for (int i = 0; i < light.length; i++) {
      double error = noise[start + i];
      differences[i] += light[i] - (double) filtered[start + i];
      variances[i] += error * error;
      means[i] += filtered[start + i];
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
