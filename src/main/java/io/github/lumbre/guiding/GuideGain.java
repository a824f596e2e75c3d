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
  private final RecordValues values;

  /** The light of the first vertex of the current path; 0 if it is not known. */
  private double first;

  /** Throughput from the first vertex. */
  private double throughput;

  private double before;
  private double after;

  private GuideGain(GuideRecords records, RecordValues values) {
    this.records = records;
    this.values = values;
  }

  /**
   * Returns the ratio of the second moments, 1 if there is no light.
   *
   * @param cells the cell of each record, or {@link Guide#NO_CELL}
   * @param means mean light that each cell scatters, by the cell over the stride
   * @param fractions part of each cell's directions that follow the guide, by the same index
   */
  static double of(
      GuideRecords records, RecordValues values, int[] cells, float[] means, float[] fractions) {
    GuideGain gain = new GuideGain(records, values);
    for (int record = 0; record < cells.length; record++) {
      int cell = cells[record] / Guide.SQUARE_STRIDE;
      boolean isLearned = cells[record] != Guide.NO_CELL;
      gain.add(record, isLearned ? means[cell] : 0, isLearned ? fractions[cell] : 0);
    }
    return gain.after > 0 ? gain.before / gain.after : 1;
  }

  private void add(int record, double mean, double fraction) {
    if (record == 0 || !records.continues(record - 1)) {
      first = mean;
      throughput = 1;
    }
    if (first > 0 && mean > 0) {
      double part = Math.min(MOST_PART, throughput * mean / first);
      double value = part * values.value(record) / mean;
      before += value * value * CellFraction.weight(records, record, 0);
      after += value * value * CellFraction.weight(records, record, fraction);
    }
    throughput =
        Math.min(Double.MAX_VALUE, throughput * records.number(record, GuideRecords.WEIGHT));
  }
}
