package io.github.lumbre.guiding;

/**
 * Predicts from records how much less noise guided paths have: the ratio of the second moments of
 * what directions give, with the BSDF alone and with each cell's mixture.
 *
 * <p>A vertex counts by the light that the path is expected to find beyond it, divided by that of
 * the path's first vertex, because this is its part in the pixel. Noise of light sampling, of
 * emission and of the pixel itself is not counted; guiding does not change it.
 */
final class GuideGain {
  /** The largest part of a vertex, so that few paths do not decide. */
  private static final double MOST_PART = 10;

  private final GuideRecords records;

  /** What each record's light counts, by the number of the record. */
  private final float[] parts;

  /** The light of the first vertex of the current path; 0 if it is not known. */
  private double first;

  /** Throughput from the first vertex. */
  private double throughput;

  private GuideGain(GuideRecords records, int count) {
    this.records = records;
    parts = new float[count];
  }

  /**
   * Returns the ratio of the second moments, 1 if there is no light.
   *
   * @param cells the cell of each record of a path, or {@link Guide#NO_CELL}
   * @param means mean light that each cell scatters, by the cell over the stride
   * @param fractions part of each cell's directions that follow the guide, by the same index
   */
  static double of(
      GuideRecords records,
      RecordValues values,
      Connections connections,
      int[] cells,
      float[] means,
      float[] fractions) {
    GuideGain gain = new GuideGain(records, cells.length);
    for (int record = 0; record < cells.length; record++) {
      boolean isLearned = cells[record] != Guide.NO_CELL;
      gain.follow(record, isLearned ? means[cells[record] / Guide.SQUARE_STRIDE] : 0);
    }
    double before = 0;
    double after = 0;
    for (int record = 0; record < records.size(); record++) {
      int start = connections.start(record);
      if (gain.parts[start] > 0) {
        double value = gain.parts[start] * values.value(record);
        double fraction = fractions[cells[start] / Guide.SQUARE_STRIDE];
        before += value * value * CellFraction.weight(records, record, 0);
        after += value * value * CellFraction.weight(records, record, fraction);
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
