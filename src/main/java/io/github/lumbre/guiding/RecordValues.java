package io.github.lumbre.guiding;

/**
 * The light that each direction of {@link GuideRecords} gives, with little noise.
 *
 * <p>The light that a single path found behind a vertex is mostly noise. Instead, the light of the
 * next vertex is the mean over the vertices around it: what they received by light sampling, and
 * what their own directions gave. These means depend on each other. They are computed in a fixed
 * number of rounds. Each round adds one more scattering (value iteration; Dahm and Keller 2017,
 * "Learning Light Transport the Reinforced Way").
 */
final class RecordValues {
  /** The largest number of vertices whose mean is taken. */
  private static final int NEIGHBORS = 32;

  private static final int ROUNDS = 8;

  private final GuideRecords records;

  /** The neighborhood of each record. */
  private final int[] neighborhoods;

  private int count;
  private final float[] values;

  RecordValues(GuideRecords records, RecordOrder[] orders) {
    this.records = records;
    neighborhoods = new int[records.size()];
    for (RecordOrder order : orders) {
      divide(order, 0, order.size());
    }
    values = new float[records.size()];
    double[] means = new double[count];
    for (int round = 0; round <= ROUNDS; round++) {
      update(means);
    }
  }

  /** Returns what a record's direction gave: light that is scattered, divided by its density. */
  float value(int record) {
    return values[record];
  }

  private void divide(RecordOrder order, int from, int to) {
    if (to - from > NEIGHBORS) {
      int axis = order.widest(from, to);
      int middle = order.divide(from, to, axis, order.median(from, to, axis));
      if (middle > from) {
        divide(order, from, middle);
        divide(order, middle, to);
        return;
      }
    }
    for (int i = from; i < to; i++) {
      neighborhoods[order.record(i)] = count;
    }
    count++;
  }

  /** Computes the values with the given means, and the means of the new values. */
  private void update(double[] means) {
    double[] sums = new double[count];
    int[] members = new int[count];
    for (int i = 0; i < values.length; i++) {
      double value = records.number(i, GuideRecords.FOUND);
      if (records.continues(i)) {
        value += records.number(i, GuideRecords.WEIGHT) * means[neighborhoods[i + 1]];
      }
      values[i] = (float) Math.min(Float.MAX_VALUE, value);
      sums[neighborhoods[i]] += records.number(i, GuideRecords.DIRECT) + values[i];
      members[neighborhoods[i]]++;
    }
    for (int i = 0; i < count; i++) {
      means[i] = members[i] == 0 ? 0 : sums[i] / members[i];
    }
  }
}
