package io.github.lumbre.integrator.guiding;

import java.util.Arrays;
import java.util.stream.IntStream;

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

  /** Returns the orders of the records by the axis that their surfaces face. */
  static RecordOrder[] ofAxes(GuideRecords records) {
    return IntStream.range(0, Guide.AXES)
        .parallel()
        .mapToObj(axis -> new RecordOrder(records, axis))
        .toArray(RecordOrder[]::new);
  }

  private RecordOrder(GuideRecords records, int axis) {
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

  int size() {
    return order.length;
  }

  /** Returns the record at a place of the order. */
  int record(int place) {
    return order[place];
  }

  /** The smallest and largest coordinates of a range of records. */
  record Extent(float[] low, float[] high) {
    /** Returns the coordinate, of three, in which the records extend most. */
    int widest() {
      int widest = 0;
      for (int axis = 1; axis < 3; axis++) {
        if (length(axis) > length(widest)) {
          widest = axis;
        }
      }
      return widest;
    }

    double length(int axis) {
      return (double) high[axis] - low[axis];
    }

    float center(int axis) {
      return .5f * low[axis] + .5f * high[axis];
    }
  }

  /** Returns where the records of a range lie. */
  Extent extent(int from, int to) {
    float[] low = {Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY};
    float[] high = {Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY};
    for (int i = from; i < to; i++) {
      for (int axis = 0; axis < 3; axis++) {
        float x = records.number(order[i], GuideRecords.X + axis);
        low[axis] = Math.min(low[axis], x);
        high[axis] = Math.max(high[axis], x);
      }
    }
    return new Extent(low, high);
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
