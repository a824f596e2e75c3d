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
   * Integers per item: minimum and maximum on x, y, z, from 0 to {@link #REACH}; its weight; its
   * number.
   */
  static final int SIZE = 8;

  static final int WEIGHT = 6;
  static final int NUMBER = 7;

  /** The largest coordinate; twice as much is still an integer. */
  static final int REACH = (1 << 30) - 1;

  /** The maximum number of items that one task quantizes. */
  private static final int MAX_PART = 1 << 14;

  /** The least surface area of a large item's box, relative to the area of the box of all items. */
  private static final double LARGE = 1 / 32.;

  /** With more large items, none is separated from the others: a room has about twelve. */
  private static final int MAX_LARGE = 16;

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
    quantize(0, source.count(), source.box());
  }

  /** Returns {@link #SIZE} integers per item. */
  int[] array() {
    return array;
  }

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
    double[] all = new double[6];
    source.copyBox(array[SIZE * first + NUMBER], all);
    double[] box = new double[6];
    for (int i = first + 1; i < end; i++) {
      source.copyBox(array[SIZE * i + NUMBER], box);
      ItemBox.grow(all, box);
    }
    return all;
  }

  /** Sets the coordinates of a range again, so that they resolve its own extent. */
  void quantize(int first, int end) {
    quantize(first, end, box(first, end));
  }

  private void quantize(int first, int end, double[] all) {
    // Halves, whose differences are finite.
    double x = .5 * all[0];
    double y = .5 * all[2];
    double z = .5 * all[4];
    double extent = Math.max(.5 * all[1] - x, Math.max(.5 * all[3] - y, .5 * all[5] - z));
    double scale = REACH / extent;
    new Quantizing(first, x, y, z, scale).runAll(end - first, MAX_PART);
  }

  /** Sets the coordinates of items, whose numbers count from the first one of a range. */
  private final class Quantizing implements RangeWork {
    private final int first;
    private final double x;
    private final double y;
    private final double z;
    private final double scale;

    Quantizing(int first, double x, double y, double z, double scale) {
      this.first = first;
      this.x = x;
      this.y = y;
      this.z = z;
      this.scale = scale;
    }

    @Override
    public void run(int from, int to) {
      double[] box = new double[6];
      for (int i = first + from; i < first + to; i++) {
        set(SIZE * i, box);
      }
    }

    /** Sets one item, in a method of its own, which Java compiles before the loop around it. */
    private void set(int at, double[] box) {
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

  /**
   * Moves large items, such as the walls of a room, before the others; returns their number, or 0
   * if there are none, too many of them, or no others. The surface area heuristic would put walls
   * into one leaf, whose box is the room, or halve the room with all its contents.
   */
  int partitionLarge() {
    int[] whole = new int[SIZE];
    for (int at = 0; at < array.length; at += SIZE) {
      for (int k = 1; k < 6; k += 2) {
        whole[k] = Math.max(whole[k], array[at + k]);
      }
    }
    double least = LARGE * BvhSplitter.halfArea(whole, 0);
    int[] large = new int[MAX_LARGE];
    int found = 0;
    for (int at = 0; at < array.length; at += SIZE) {
      if (BvhSplitter.halfArea(array, at) >= least) {
        if (found == MAX_LARGE) {
          return 0;
        }
        large[found++] = at;
      }
    }
    if (found == count()) {
      return 0;
    }
    for (int i = 0; i < found; i++) {
      swap(array, SIZE * i, large[i]);
    }
    return found;
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
