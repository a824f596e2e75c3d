package io.github.lumbre.render.denoise;

import java.util.Arrays;

/**
 * Filters channels further that keep far more noise, relative to their light, than the others: the
 * network's kernels are the same for all channels, and red plastic under white light has most of
 * its relative noise in green and blue. In a window of pixels, values move towards the mean by the
 * part of their variance that noise explains (Lee 1980, local linear minimum mean square error).
 * Immutable.
 */
final class UnevenNoise {
  private static final int RADIUS = 4;

  /** Relative noise of a channel, divided by that of the mean of the channels, that is ordinary. */
  private static final double EVEN = 1.5;

  /** The same ratio, from which on all noise is removed. */
  private static final double UNEVEN = 3;

  /** Light of the network's scale that is added where noise is divided by light. */
  private static final double DARK = .01;

  private static final int SUMS = 3;

  private final Features picture;
  private final float[] filtered;
  private final float[] noise;
  private final int width;
  private final double dark;

  /**
   * @param filtered the network's result, three values for each pixel
   * @param noise that the result has left
   */
  UnevenNoise(Features picture, float[] filtered, float[] noise) {
    this.picture = picture;
    this.filtered = filtered;
    this.noise = noise;
    width = picture.width();
    dark = picture.unscaled(DARK);
  }

  /** Writes pixels of a row of the result from a column to another. */
  void write(int y, int start, int stop, float[] result) {
    int first = Math.max(0, y - RADIUS);
    int end = Math.min(picture.height(), y + RADIUS + 1);
    double[] columns = columns(first, end, start, stop);
    double[] sums = new double[3 * SUMS];
    for (int x = start; x < stop; x++) {
      int left = Math.max(0, x - RADIUS);
      int right = Math.min(width, x + RADIUS + 1);
      Arrays.fill(sums, 0);
      for (int near = left; near < right; near++) {
        for (int k = 0; k < sums.length; k++) {
          sums[k] += columns[sums.length * near + k];
        }
      }
      for (int k = 0; k < sums.length; k++) {
        sums[k] /= (right - left) * (end - first);
      }
      move(3 * (y * width + x), sums, result);
    }
  }

  /** Returns for each column and channel the sums of values, their squares and those of noise. */
  private double[] columns(int first, int end, int start, int stop) {
    double[] columns = new double[3 * SUMS * width];
    int from = 3 * Math.max(0, start - RADIUS);
    int to = 3 * Math.min(width, stop + RADIUS);
    for (int row = first; row < end; row++) {
      for (int i = from; i < to; i++) {
        double value = filtered[3 * row * width + i];
        double error = noise[3 * row * width + i];
        columns[SUMS * i] += value;
        columns[SUMS * i + 1] += value * value;
        columns[SUMS * i + 2] += error * error;
      }
    }
    return columns;
  }

  /** Moves the values of a pixel towards the means of its window. */
  private void move(int pixel, double[] means, float[] result) {
    double light = (means[0] + means[SUMS] + means[2 * SUMS]) / 3;
    double deviation =
        (Math.sqrt(means[2]) + Math.sqrt(means[SUMS + 2]) + Math.sqrt(means[2 * SUMS + 2])) / 3;
    for (int c = 0; c < 3; c++) {
      double mean = means[SUMS * c];
      double variance = means[SUMS * c + 1] - mean * mean;
      double explained = means[SUMS * c + 2];
      double ordinary = deviation * (mean + dark) / (light + dark);
      double ratio = deviation > 0 ? Math.sqrt(explained) / ordinary : 0;
      double share = Math.max(0, Math.min(1, (ratio - EVEN) / (UNEVEN - EVEN)));
      double kept = variance > 0 ? Math.max(0, 1 - share * explained / variance) : 1;
      result[pixel + c] = (float) (mean + kept * (filtered[pixel + c] - mean));
    }
  }
}
