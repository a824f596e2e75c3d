package io.github.lumbre.image.gif;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Chooses the colors of a palette: boxes of colors are split at their mean where the error is
 * largest (after Wan, Prusinkiewicz and Wong 1990, "Variance-based color image quantization for
 * frame buffer display"), and k-means steps then move the colors (Lloyd 1982). Mutable.
 */
final class ColorClusters {
  private static final int STEPS = 12;

  /** The counts of the occupied cells, and their mean red, green and blue. */
  private final long[] counts;

  private final int[][] means;

  /** The occupied cells, those of each box together. */
  private final int[] order;

  private ColorClusters(ColorHistogram histogram) {
    int[] cells =
        IntStream.range(0, ColorHistogram.CELLS)
            .filter(cell -> histogram.count(cell) > 0)
            .toArray();
    counts = Arrays.stream(cells).mapToLong(histogram::count).toArray();
    means = new int[3][];
    for (int c = 0; c < 3; c++) {
      int channel = c;
      means[c] = Arrays.stream(cells).map(cell -> histogram.mean(cell, channel)).toArray();
    }
    order = IntStream.range(0, cells.length).toArray();
  }

  /** Returns at most a number of colors that stand for all colors. */
  static int[] of(ColorHistogram histogram, int most) {
    ColorClusters clusters = new ColorClusters(histogram);
    int[] colors = NearestColor.sorted(clusters.split(most));
    for (int step = 0; step < STEPS; step++) {
      colors = clusters.moved(colors);
    }
    return colors;
  }

  /**
   * Some cells, and how to split them.
   *
   * @param from position in {@link #order}
   * @param to position after the last cell
   * @param mean red, green and blue
   * @param channel with the largest error
   * @param error sum of the weighted squared differences from the mean in that channel
   */
  private record Box(int from, int to, int[] mean, int channel, long error) {}

  private int[] split(int most) {
    List<Box> boxes = new ArrayList<>(List.of(box(0, order.length)));
    while (boxes.size() < most) {
      int worst = 0;
      for (int i = 1; i < boxes.size(); i++) {
        worst = boxes.get(i).error > boxes.get(worst).error ? i : worst;
      }
      Box box = boxes.get(worst);
      if (box.error == 0) {
        break;
      }
      int middle = partition(box);
      boxes.set(worst, box(box.from, middle));
      boxes.add(box(middle, box.to));
    }
    return boxes.stream().mapToInt(box -> rgb(box.mean)).toArray();
  }

  private Box box(int from, int to) {
    int[] mean = new int[3];
    int worst = 0;
    long largest = 0;
    for (int channel = 0; channel < 3; channel++) {
      long count = 0;
      long sum = 0;
      for (int i = from; i < to; i++) {
        count += counts[order[i]];
        sum += counts[order[i]] * means[channel][order[i]];
      }
      mean[channel] = (int) (sum / count);
      long error = 0;
      for (int i = from; i < to; i++) {
        int difference = means[channel][order[i]] - mean[channel];
        error += counts[order[i]] * NearestColor.WEIGHTS[channel] * difference * difference;
      }
      if (error > largest) {
        largest = error;
        worst = channel;
      }
    }
    return new Box(from, to, mean, worst, largest);
  }

  /** Moves the cells above the mean to the end of a box, and returns the first one's position. */
  private int partition(Box box) {
    int[] values = means[box.channel];
    int middle = box.from;
    for (int i = box.from; i < box.to; i++) {
      int cell = order[i];
      if (values[cell] <= box.mean[box.channel]) {
        order[i] = order[middle];
        order[middle++] = cell;
      }
    }
    return middle;
  }

  /** Returns the means of the cells that are nearest to each color. */
  private int[] moved(int[] colors) {
    NearestColor nearest = new NearestColor(colors);
    long[] count = new long[colors.length];
    long[][] sums = new long[3][colors.length];
    for (int cell = 0; cell < counts.length; cell++) {
      int index = nearest.index(means[0][cell], means[1][cell], means[2][cell]);
      count[index] += counts[cell];
      for (int channel = 0; channel < 3; channel++) {
        sums[channel][index] += counts[cell] * means[channel][cell];
      }
    }
    int[] moved = colors.clone();
    for (int i = 0; i < moved.length; i++) {
      if (count[i] > 0) {
        int[] mean = new int[3];
        for (int channel = 0; channel < 3; channel++) {
          mean[channel] = (int) ((sums[channel][i] + count[i] / 2) / count[i]);
        }
        moved[i] = rgb(mean);
      }
    }
    return NearestColor.sorted(moved);
  }

  private static int rgb(int[] mean) {
    return mean[0] << 16 | mean[1] << 8 | mean[2];
  }
}
