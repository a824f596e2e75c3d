package io.github.lumbre.integrator.guiding;

/**
 * Chooses the part of a cell's directions that follow the guide. The others follow the BSDF.
 *
 * <p>The choice minimizes the second moment of what the directions give. It is estimated for
 * several parts from the same records: a record that was drawn with density p counts p / q, if q is
 * its density with another part. The guide's density is that of the guide which drew the record.
 * That guide has not seen the record, so that it does not seem better than it is. (Müller 2019,
 * "Path Guiding in Production", learns the part by gradient descent instead.)
 */
final class CellFraction {
  /** The part while guides are learned. A power of two keeps the points of both evenly spread. */
  static final float TRAINING = .5f;

  private static final float[] FRACTIONS = {0, .25f, .5f, .75f, .875f};

  /**
   * A cell is guided if that makes the second moment smaller than this part of the moment without a
   * guide. Guided directions cost time, and small gains are often due to chance.
   */
  private static final double MOST_MOMENT = .75;

  /** The largest weight of a record: the BSDF alone may almost never draw its direction. */
  private static final double MOST_WEIGHT = 1000;

  private CellFraction() {}

  /** Returns the best part, in [0,1), for the records of a cell. */
  static float best(GuideRecords records, RecordValues values, RecordOrder order) {
    double[] moments = new double[FRACTIONS.length];
    for (int i = 0; i < order.size(); i++) {
      int record = order.record(i);
      double value = values.value(record);
      for (int k = 0; k < moments.length; k++) {
        moments[k] += value * value * weight(records, record, FRACTIONS[k]);
      }
    }
    int best = 0;
    double least = MOST_MOMENT * moments[0];
    for (int k = 1; k < moments.length; k++) {
      if (moments[k] < least) {
        best = k;
        least = moments[k];
      }
    }
    return FRACTIONS[best];
  }

  /**
   * Returns the weight of a record's square if a part of the directions follows the guide. Delta
   * lobes only lose the directions that follow the guide. {@link Connections} never draw them, and
   * are half of all directions.
   */
  static double weight(GuideRecords records, int record, double fraction) {
    double pdf = records.number(record, GuideRecords.PDF);
    if (pdf == 0) {
      return .5 * (1 - TRAINING) / (1 - fraction);
    }
    double bsdf = records.number(record, GuideRecords.BSDF_PDF);
    double guide = Math.max(0, (pdf - (1 - TRAINING) * bsdf) / TRAINING);
    double allPdf = records.number(record, GuideRecords.ALL_PDF);
    return Math.min(MOST_WEIGHT, allPdf / (fraction * guide + (1 - fraction) * bsdf));
  }
}
