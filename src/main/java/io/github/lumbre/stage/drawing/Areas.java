package io.github.lumbre.stage.drawing;

import java.util.Arrays;
import java.util.List;

/** Finds which part of each pixel is inside closed outlines. Mutable; for one thread. */
final class Areas {
  /** Lines through each row of pixels. */
  private static final int LINES = 16;

  private final int width;

  /** The x of each crossing of an outline, by the lines through the rows. */
  private final double[][] crossings;

  private final int[] counts;

  Areas(List<double[]> outlines, int width, int height) {
    this.width = width;
    crossings = new double[height * LINES][];
    counts = new int[crossings.length];
    for (double[] outline : outlines) {
      for (int i = 0; i + 3 < outline.length; i += 2) {
        add(outline[i], outline[i + 1], outline[i + 2], outline[i + 3]);
      }
    }
  }

  private void add(double x, double y, double toX, double toY) {
    // A line is crossed once where two segments meet on it.
    double first = Math.ceil(Math.min(y, toY) * LINES - .5);
    double end = Math.ceil(Math.max(y, toY) * LINES - .5);
    for (int line = (int) Math.max(0, first); line < Math.min(end, counts.length); line++) {
      double share = ((line + .5) / LINES - y) / (toY - y);
      double[] known = crossings[line] == null ? new double[4] : crossings[line];
      int size = counts[line] == known.length ? 2 * known.length : known.length;
      crossings[line] = size == known.length ? known : Arrays.copyOf(known, size);
      crossings[line][counts[line]++] = x + share * (toX - x);
    }
  }

  /** Returns the part of each pixel of a row that is inside an odd number of outlines. */
  double[] shares(int row) {
    double[] shares = new double[width];
    for (int line = row * LINES; line < (row + 1) * LINES; line++) {
      if (counts[line] > 0) {
        Arrays.sort(crossings[line], 0, counts[line]);
      }
      for (int i = 0; i + 1 < counts[line]; i += 2) {
        add(crossings[line][i], crossings[line][i + 1], shares);
      }
    }
    return shares;
  }

  private void add(double from, double to, double... shares) {
    double low = Math.max(0, from);
    double high = Math.min(width, to);
    for (int column = (int) low; column < high; column++) {
      double inside = Math.min(high, column + 1) - Math.max(low, column);
      shares[column] += Math.max(0, inside) / LINES;
    }
  }
}
