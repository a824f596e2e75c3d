package io.github.lumbre.integrator.guiding;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

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

  /** All records, by neighborhood. */
  private final int[] members;

  /** The first member of each neighborhood, and the end of the last one. */
  private final int[] starts;

  /** The neighborhood of each record. */
  private final int[] neighborhoods;

  /** Area per record, by neighborhood. */
  private final double[] areas;

  private final float[] values;
  private double[] means;

  /**
   * Computes the values.
   *
   * @param orders the records by axis; they are sorted
   */
  RecordValues(GuideRecords records, RecordOrder[] orders) {
    this.records = records;
    List<List<RecordRange>> divided =
        Arrays.stream(orders).parallel().map(RecordValues::neighborhoods).toList();
    List<RecordRange> ranges = divided.stream().flatMap(List::stream).toList();
    members = new int[records.size()];
    neighborhoods = new int[records.size()];
    values = new float[2 * records.size()];
    areas = new double[ranges.size()];
    means = new double[ranges.size()];
    starts = new int[ranges.size() + 1];
    for (int i = 0; i < ranges.size(); i++) {
      starts[i + 1] = starts[i] + ranges.get(i).size();
    }
    IntStream.range(0, means.length).parallel().forEach(i -> enter(i, ranges.get(i)));
    for (int round = 0; round <= ROUNDS; round++) {
      means = IntStream.range(0, means.length).parallel().mapToDouble(this::update).toArray();
    }
  }

  /**
   * Returns what a record's direction gave: light that is scattered, divided by its density. 0 of a
   * connection that was not added.
   */
  float value(int record) {
    return values[record];
  }

  /** Sets what a direction gave. */
  void set(int record, double value) {
    values[record] = (float) Math.min(Float.MAX_VALUE, value);
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

  private static List<RecordRange> neighborhoods(RecordOrder order) {
    List<RecordRange> result = new ArrayList<>();
    if (order.size() > 0) {
      divide(order, 0, order.size(), result);
    }
    return result;
  }

  private static void divide(RecordOrder order, int from, int to, List<RecordRange> result) {
    if (to - from > NEIGHBORS) {
      RecordOrder.Extent extent = order.extent(from, to);
      int axis = extent.widest();
      // Halves of the extent, not of the records: few vertices of a small bright surface must not
      // share their mean with many of a large dark one.
      int middle = order.divide(from, to, axis, extent.center(axis));
      if (middle > from && middle < to) {
        divide(order, from, middle, result);
        divide(order, middle, to, result);
        return;
      }
    }
    result.add(new RecordRange(order, from, to));
  }

  private void enter(int neighborhood, RecordRange range) {
    for (int i = 0; i < range.size(); i++) {
      members[starts[neighborhood] + i] = range.record(i);
      neighborhoods[range.record(i)] = neighborhood;
    }
    areas[neighborhood] = area(range) / range.size();
  }

  /**
   * Returns the area of the surface in the box around a range. A box around n random points of an
   * interval has (n - 1) / (n + 1) of its length on average.
   */
  private double area(RecordRange range) {
    if (range.size() < 2) {
      return 0;
    }
    double part = (range.size() - 1.) / (range.size() + 1);
    int facing = (int) records.number(range.record(0), GuideRecords.AXIS) / 2;
    double cosine = 0;
    for (int i = 0; i < range.size(); i++) {
      cosine += Math.abs(records.number(range.record(i), GuideRecords.NORMAL + facing));
    }
    double area = range.size() / cosine;
    RecordOrder.Extent extent = range.order().extent(range.from(), range.to());
    for (int axis = 0; axis < 3; axis++) {
      area *= axis == facing ? 1 : extent.length(axis) / part;
    }
    return area < Double.POSITIVE_INFINITY ? area : 0;
  }

  /** Computes the values of a neighborhood from the means; returns the mean of the new values. */
  private double update(int neighborhood) {
    double sum = 0;
    double weights = 0;
    for (int i = starts[neighborhood]; i < starts[neighborhood + 1]; i++) {
      int record = members[i];
      double value = records.number(record, GuideRecords.FOUND);
      if (records.continues(record)) {
        value += records.number(record, GuideRecords.WEIGHT) * means[neighborhoods[record + 1]];
      }
      values[record] = (float) Math.min(Float.MAX_VALUE, value);
      double weight = arrival(record);
      sum += weight * (records.number(record, GuideRecords.DIRECT) + values[record]);
      weights += weight;
    }
    return weights > 0 ? sum / weights : 0;
  }
}
