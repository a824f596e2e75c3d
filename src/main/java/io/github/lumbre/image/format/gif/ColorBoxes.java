package io.github.lumbre.image.format.gif;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Chooses the colors of a palette: boxes of colors are split at their mean where the error is
 * largest (after Wan, Prusinkiewicz and Wong 1990, "Variance-based color image quantization for
 * frame buffer display"). Mutable.
 */
final class ColorBoxes {
  private final ColorHistogram histogram;

  /** The occupied cells, those of each box together. */
  private final int[] cells;

  private ColorBoxes(ColorHistogram histogram) {
    this.histogram = histogram;
    cells =
        IntStream.range(0, ColorHistogram.CELLS)
            .filter(cell -> histogram.count(cell) > 0)
            .toArray();
  }

  /**
   * Some cells, and where to split them.
   *
   * @param from position in {@link #cells}
   * @param to position after the last cell
   * @param mean red, green and blue, rounded down
   * @param channel with the largest error
   * @param error sum of the weighted squared differences from the mean in that channel
   */
  private record Box(int from, int to, int[] mean, int channel, long error) {}

  /** Returns at most a number of colors that stand for all colors. */
  static int[] colors(ColorHistogram histogram, int most) {
    return new ColorBoxes(histogram).split(most);
  }

  private int[] split(int most) {
    List<Box> boxes = new ArrayList<>(List.of(box(0, cells.length)));
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
    return boxes.stream()
        .mapToInt(box -> box.mean[0] << 16 | box.mean[1] << 8 | box.mean[2])
        .toArray();
  }

  private Box box(int from, int to) {
    int[] mean = new int[3];
    int worst = 0;
    long largest = 0;
    for (int channel = 0; channel < 3; channel++) {
      long count = 0;
      long sum = 0;
      for (int i = from; i < to; i++) {
        count += histogram.count(cells[i]);
        sum += histogram.count(cells[i]) * histogram.mean(cells[i], channel);
      }
      mean[channel] = (int) (sum / count);
      long error = 0;
      for (int i = from; i < to; i++) {
        int difference = histogram.mean(cells[i], channel) - mean[channel];
        error += histogram.count(cells[i]) * difference * difference;
      }
      if (error * NearestColor.WEIGHTS[channel] > largest) {
        largest = error * NearestColor.WEIGHTS[channel];
        worst = channel;
      }
    }
    return new Box(from, to, mean, worst, largest);
  }

  /** Moves the cells above the mean to the end of a box, and returns the first one's position. */
  private int partition(Box box) {
    int middle = box.from;
    for (int i = box.from; i < box.to; i++) {
      int cell = cells[i];
      if (histogram.mean(cell, box.channel) <= box.mean[box.channel]) {
        cells[i] = cells[middle];
        cells[middle++] = cell;
      }
    }
    return middle;
  }
}
