package io.github.lumbre.guiding;

import java.util.Arrays;

/**
 * The light that each direction of {@link GuideRecords} gives, with little noise.
 *
 * <p>The light that a single path found behind a vertex is mostly noise. Instead, the light of the
 * next vertex is the mean over the vertices around it: what they received by light sampling, and
 * what their own directions gave, by the weight with which paths arrived there. These means depend
 * on each other. They are computed in a fixed number of rounds. Each round adds one more scattering
 * (value iteration; Dahm and Keller 2017, "Learning Light Transport the Reinforced Way").
 */
final class RecordValues {
  /** The largest number of vertices whose mean is taken. */
  private static final int NEIGHBORS = 32;

  private static final int ROUNDS = 8;

  private final GuideRecords records;

  /** The neighborhood of each record. */
  private final int[] neighborhoods;

  private int count;
  private float[] values;
  private int size;
  private double[] areas = new double[64];
  private double[] means;

  RecordValues(GuideRecords records, RecordOrder[] orders) {
    this.records = records;
    neighborhoods = new int[records.size()];
    for (RecordOrder order : orders) {
      divide(order, 0, order.size());
    }
    size = records.size();
    values = new float[size];
    means = new double[count];
    for (int round = 0; round <= ROUNDS; round++) {
      update();
    }
  }

  /** Returns what a record's direction gave: light that is scattered, divided by its density. */
  float value(int record) {
    return values[record];
  }

  /** Multiplies a value. */
  void scale(int record, double factor) {
    values[record] = (float) Math.min(Float.MAX_VALUE, factor * values[record]);
  }

  /** Adds the value of a record that was added. */
  void add(double value) {
    if (values.length == size) {
      values = Arrays.copyOf(values, 2 * size);
    }
    values[size++] = (float) Math.min(Float.MAX_VALUE, value);
  }

  /** Returns the mean light around a record. */
  double mean(int record) {
    return means[neighborhoods[record]];
  }

  /** Returns the area around a record, in world space, over the number of records in it. */
  double area(int record) {
    return areas[neighborhoods[record]];
  }

  /**
   * Returns the weight with which a path arrived at a vertex. Guided paths arrive more often, and
   * with less weight, where they see more light.
   */
  private double arrival(int record) {
    boolean isFirst = record == 0 || !records.continues(record - 1);
    return isFirst ? 1 : records.number(record - 1, GuideRecords.WEIGHT);
  }

  private void divide(RecordOrder order, int from, int to) {
    if (to - from > NEIGHBORS) {
      int axis = order.widest(from, to);
      // Halves of the extent, not of the records: few vertices of a small bright surface must not
      // share their mean with many of a large dark one.
      int middle = order.divide(from, to, axis, order.center(from, to, axis));
      if (middle > from && middle < to) {
        divide(order, from, middle);
        divide(order, middle, to);
        return;
      }
    }
    for (int i = from; i < to; i++) {
      neighborhoods[order.record(i)] = count;
    }
    if (areas.length == count) {
      areas = Arrays.copyOf(areas, 2 * count);
    }
    areas[count++] = area(order, from, to) / (to - from);
  }

  /**
   * Returns the area of the surface in the box around a range. A box around n random points of an
   * interval has (n - 1) / (n + 1) of its length on average.
   */
  private double area(RecordOrder order, int from, int to) {
    if (to - from < 2) {
      return 0;
    }
    double part = (to - from - 1.) / (to - from + 1);
    int facing = (int) records.number(order.record(from), GuideRecords.AXIS) / 2;
    double cosine = 0;
    for (int i = from; i < to; i++) {
      cosine += Math.abs(records.number(order.record(i), GuideRecords.NORMAL + facing));
    }
    double area = (to - from) / cosine;
    for (int axis = 0; axis < 3; axis++) {
      area *= axis == facing ? 1 : order.extent(from, to, axis) / part;
    }
    return area < Double.POSITIVE_INFINITY ? area : 0;
  }

  /** Computes the values with the means, and the means of the new values. */
  private void update() {
    double[] sums = new double[count];
    double[] weights = new double[count];
    for (int i = 0; i < values.length; i++) {
      double value = records.number(i, GuideRecords.FOUND);
      if (records.continues(i)) {
        value += records.number(i, GuideRecords.WEIGHT) * means[neighborhoods[i + 1]];
      }
      values[i] = (float) Math.min(Float.MAX_VALUE, value);
      double weight = arrival(i);
      sums[neighborhoods[i]] += weight * (records.number(i, GuideRecords.DIRECT) + values[i]);
      weights[neighborhoods[i]] += weight;
    }
    for (int i = 0; i < count; i++) {
      means[i] = weights[i] > 0 ? sums[i] / weights[i] : 0;
    }
  }
}
