package io.github.lumbre.guiding;

/**
 * Predicts from records how much less noise guided paths have: the ratio of the second moments of
 * what directions give, with the BSDF alone and with each cell's mixture.
 *
 * <p>A vertex counts by the light that the path is expected to find beyond it, divided by that of
 * the path's first vertex, because this is its part in the pixel. Noise of light sampling, of
 * emission and of the pixel itself is not counted; guiding does not change it. Mutable; used once.
 */
final class GuideGain {
  /** The largest part of a vertex, so that few paths do not decide. */
  private static final double MOST_PART = 10;

  private final GuideRecords records;
  private final RecordValues values;
  private final Connections connections;

  /** Mean light that the cell of each record scatters; 0 without a cell. */
  private final float[] means;

  /** Part of the directions of the cell of each record that follow the guide. */
  private final float[] fractions;

  /** What each record's light counts, by the number of the record. */
  private final float[] parts;

  /** The light of the first vertex of the current path; 0 if it is not known. */
  private double first;

  /** Throughput from the first vertex. */
  private double throughput;

  GuideGain(GuideRecords records, RecordValues values, Connections connections) {
    this.records = records;
    this.values = values;
    this.connections = connections;
    means = new float[records.size()];
    fractions = new float[records.size()];
    parts = new float[records.size()];
  }

  /**
   * Adds a cell.
   *
   * @param mean light that it scatters
   * @param fraction part of its directions that follow the guide
   */
  void add(RecordRange cell, float mean, float fraction) {
    for (int i = 0; i < cell.size(); i++) {
      means[cell.record(i)] = mean;
      fractions[cell.record(i)] = fraction;
    }
  }

  /** Returns the ratio of the second moments of all cells, 1 if there is no light. */
  double get() {
    int count = records.size();
    for (int record = 0; record < count; record++) {
      follow(record, means[record]);
    }
    double before = 0;
    double after = 0;
    for (int record = 0; record < 2 * count; record++) {
      int start = connections.start(record);
      if (parts[start] > 0 && (record < count || records.isConnected(record))) {
        double value = parts[start] * values.value(record);
        before += value * value * CellFraction.weight(records, record, 0);
        after += value * value * CellFraction.weight(records, record, fractions[start]);
      }
    }
    return after > 0 ? before / after : 1;
  }

  private void follow(int record, double mean) {
    if (record == 0 || !records.continues(record - 1)) {
      first = mean;
      throughput = 1;
    }
    if (first > 0 && mean > 0) {
      double part = Math.min(MOST_PART, throughput * mean / first);
      parts[record] = (float) Math.min(Float.MAX_VALUE, part / mean);
    }
    throughput =
        Math.min(Double.MAX_VALUE, throughput * records.number(record, GuideRecords.WEIGHT));
  }
}
