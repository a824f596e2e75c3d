package io.github.lumbre.geometry;

/**
 * The items of a hierarchy while it is built, in an order that the builder changes. Mutable and
 * shared; each thread works on its own range.
 *
 * <p>The coordinates of the items' boxes are integers, rounded down. They only choose the splits;
 * the boxes of nodes are computed from the exact boxes. Integers take less memory than doubles.
 */
final class BuildItems {
  /**
   * Integers per item: minimum and maximum on x, y, z, from 0 to {@link #REACH}; its number; and
   * its weight.
   */
  static final int SIZE = 8;

  static final int NUMBER = 6;
  static final int WEIGHT = 7;

  /** The largest coordinate; twice as much is still an integer. */
  static final int REACH = (1 << 30) - 1;

  /** The maximum number of items that one task quantizes. */
  private static final int MAX_PART = 1 << 14;

  private final BvhItems source;
  private final int[] array;

  /** Creates the items in the order of their numbers. */
  BuildItems(BvhItems source, LeafCost costs) {
    this.source = source;
    array = new int[SIZE * source.count()];
    for (int i = 0; i < source.count(); i++) {
      array[SIZE * i + NUMBER] = i;
      array[SIZE * i + WEIGHT] = costs.weight(i < source.triangleCount());
    }
    quantize(0, source.count());
  }

  /** Returns {@link #SIZE} integers per item. */
  int[] array() {
    return array;
  }

  /** Returns the number of items. */
  int count() {
    return source.count();
  }

  /** Returns the item numbers in the present order. */
  int[] order() {
    int[] order = new int[count()];
    for (int i = 0; i < order.length; i++) {
      order[i] = array[SIZE * i + NUMBER];
    }
    return order;
  }

  /** Returns the exact box of a range. */
  double[] box(int first, int end) {
    double[] all = BvhNode.EMPTY.clone();
    double[] box = new double[6];
    for (int i = first; i < end; i++) {
      source.copyBox(array[SIZE * i + NUMBER], box);
      BvhNode.grow(all, box);
    }
    return all;
  }

  /** Sets the coordinates of a range again, so that they resolve its own extent. */
  void quantize(int first, int end) {
    double[] all = box(first, end);
    // Halves, whose differences are finite.
    double x = .5 * all[0];
    double y = .5 * all[2];
    double z = .5 * all[4];
    double extent = Math.max(.5 * all[1] - x, Math.max(.5 * all[3] - y, .5 * all[5] - z));
    double scale = REACH / extent;
    ParallelRange.run(
        end - first, MAX_PART, (from, to) -> quantize(first + from, first + to, x, y, z, scale));
  }

  private void quantize(int first, int end, double x, double y, double z, double scale) {
    double[] box = new double[6];
    for (int at = SIZE * first; at < SIZE * end; at += SIZE) {
      source.copyBox(array[at + NUMBER], box);
      array[at] = quantized((.5 * box[0] - x) * scale);
      array[at + 1] = quantized((.5 * box[1] - x) * scale);
      array[at + 2] = quantized((.5 * box[2] - y) * scale);
      array[at + 3] = quantized((.5 * box[3] - y) * scale);
      array[at + 4] = quantized((.5 * box[4] - z) * scale);
      array[at + 5] = quantized((.5 * box[5] - z) * scale);
    }
  }

  /** Returns an integer from 0 to {@link #REACH}; 0 for NaN, which only a tiny extent yields. */
  private static int quantized(double coordinate) {
    return Math.min((int) coordinate, REACH);
  }

  /** Moves triangles before shapes; returns the position of the first shape. */
  int partitionKinds(int first, int end) {
    int middle = first;
    for (int i = first; i < end; i++) {
      if (array[SIZE * i + NUMBER] < source.triangleCount()) {
        swap(array, SIZE * i, SIZE * middle++);
      }
    }
    return middle;
  }

  /** Swaps two items, given by their offsets. */
  static void swap(int[] array, int a, int b) {
    for (int k = 0; k < SIZE; k++) {
      int value = array[a + k];
      array[a + k] = array[b + k];
      array[b + k] = value;
    }
  }
}
