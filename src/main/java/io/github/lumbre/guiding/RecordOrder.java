package io.github.lumbre.guiding;

import java.util.Arrays;

/**
 * An order of {@link GuideRecords} that is divided into ever smaller ranges. Each division keeps
 * the order within the halves, so that sums over a range are always taken in the same order.
 * Mutable.
 */
final class RecordOrder {
  private static final int MEDIAN_RECORDS = 255;

  private final GuideRecords records;
  private final int[] order;
  private final int[] high;

  /** Creates the order of the records whose surfaces face an axis. */
  RecordOrder(GuideRecords records, int axis) {
    this.records = records;
    int[] all = new int[records.size()];
    int size = 0;
    for (int i = 0; i < all.length; i++) {
      if (records.number(i, GuideRecords.AXIS) == axis) {
        all[size++] = i;
      }
    }
    order = Arrays.copyOf(all, size);
    high = new int[size];
  }

  /** Creates an order of given records. It owns the array. */
  RecordOrder(GuideRecords records, int[] order) {
    this.records = records;
    this.order = order;
    high = new int[order.length];
  }

  /** Returns the number of records. */
  int size() {
    return order.length;
  }

  /** Returns the record at a place of the order. */
  int record(int place) {
    return order[place];
  }

  /** Returns the coordinate, of three, in which the records of a range extend most. */
  int widest(int from, int to) {
    float[] low = {Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY};
    float[] high = {Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY};
    for (int i = from; i < to; i++) {
      for (int axis = 0; axis < 3; axis++) {
        float x = records.number(order[i], axis);
        low[axis] = Math.min(low[axis], x);
        high[axis] = Math.max(high[axis], x);
      }
    }
    int widest = 0;
    for (int axis = 1; axis < 3; axis++) {
      if ((double) high[axis] - low[axis] > (double) high[widest] - low[widest]) {
        widest = axis;
      }
    }
    return widest;
  }

  /** Returns the length of a range in one coordinate. */
  double extent(int from, int to, int axis) {
    float[] bounds = bounds(from, to, axis);
    return (double) bounds[1] - bounds[0];
  }

  /** Returns the center of a range in one coordinate. */
  float center(int from, int to, int axis) {
    float[] bounds = bounds(from, to, axis);
    return .5f * bounds[0] + .5f * bounds[1];
  }

  private float[] bounds(int from, int to, int axis) {
    float low = Float.POSITIVE_INFINITY;
    float high = Float.NEGATIVE_INFINITY;
    for (int i = from; i < to; i++) {
      float x = records.number(order[i], axis);
      low = Math.min(low, x);
      high = Math.max(high, x);
    }
    return new float[] {low, high};
  }

  /**
   * Returns a number below which lie about half of a range's records. It is the median of at most
   * {@link #MEDIAN_RECORDS} of them, because sorting all took a fifth of the pilot's time.
   */
  float median(int from, int to, int index) {
    int step = (to - from + MEDIAN_RECORDS - 1) / MEDIAN_RECORDS;
    float[] numbers = new float[(to - from + step - 1) / step];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = records.number(order[from + i * step], index);
    }
    Arrays.sort(numbers);
    return numbers[numbers.length / 2];
  }

  /**
   * Moves the records of a range whose number is below a limit to the front.
   *
   * @return the first place of the others
   */
  int divide(int from, int to, int index, float limit) {
    int low = from;
    int others = 0;
    for (int i = from; i < to; i++) {
      int record = order[i];
      if (records.number(record, index) < limit) {
        order[low++] = record;
      } else {
        high[others++] = record;
      }
    }
    System.arraycopy(high, 0, order, low, others);
    return low;
  }
}
