package io.github.lumbre.denoise;

/**
 * How similar two pixels are: 1 if their surroundings and their features differ only by noise, down
 * to 0. Color is compared over squares of 5x5 pixels, as non-local means do (Rousselle, Knaus &amp;
 * Zwicker 2012, "Adaptive Rendering with Non-Local Means Filtering"), features pixel by pixel
 * (Rousselle, Manzi &amp; Zwicker 2013, "Robust Denoising using Feature and Color Information").
 *
 * @param color what to compare, of three channels
 * @param variance of the color
 * @param features further values that must be similar; may have no channels
 * @param featureVariance variance of the features
 * @param scales tolerances
 * @param slack what two values contribute to the denominator of their distance, for each value of
 *     the color
 */
record Similarity(
    Raster color,
    Raster variance,
    Raster features,
    Raster featureVariance,
    Scales scales,
    Raster slack) {
  /** Half of the side of the compared squares. */
  static final int PATCH = 2;

  /** Distances beyond this one have weight 0. */
  static final double LARGEST = 8;

  /** Differences of this share of the color do not count. */
  private static final float COLOR_FLOOR = 1e-4f;

  private static final double FEATURE_FLOOR = 1e-3;

  /**
   * Tolerances: larger values make more pixels similar.
   *
   * @param color in standard deviations of the color
   * @param feature in standard deviations of the features
   */
  record Scales(double color, double feature) {}

  static Similarity of(
      Raster color, Raster variance, Raster features, Raster featureVariance, Scales scales) {
    float scale = (float) (scales.color * scales.color);
    Raster slack =
        color.with(variance, (value, of) -> COLOR_FLOOR * (.5 + value * value) + scale * of);
    return new Similarity(color, variance, features, featureVariance, scales, slack);
  }

  /** Buffers for {@link #distances}: loops over them can use vector instructions. */
  static final class Rows {
    private final float[][] rows;

    /**
     * @param most largest number of values
     */
    Rows(int most) {
      rows = new float[6][most];
    }
  }

  /**
   * Computes distances between values of the color and others, which are shifted by an offset.
   *
   * @param first index of the first value
   * @param shift what to add to the index of a value to get that of the other
   * @param count number of values
   * @param rows buffers, overwritten
   * @param result gets the distances
   */
  void distances(int first, int shift, int count, Rows rows, float[] result) {
    float[] a = copied(color, first, count, rows.rows[0]);
    float[] b = copied(color, first + shift, count, rows.rows[1]);
    float[] ofA = copied(variance, first, count, rows.rows[2]);
    float[] ofB = copied(variance, first + shift, count, rows.rows[3]);
    float[] slackA = copied(slack, first, count, rows.rows[4]);
    float[] slackB = copied(slack, first + shift, count, rows.rows[5]);
    for (int i = 0; i < count; i++) {
      float difference = a[i] - b[i];
      float beyondNoise = difference * difference - (ofA[i] + Math.min(ofA[i], ofB[i]));
      result[i] = beyondNoise / (slackA[i] + slackB[i]);
    }
  }

  private static float[] copied(Raster raster, int first, int count, float[] row) {
    System.arraycopy(raster.values(), first, row, 0, count);
    return row;
  }

  /**
   * Returns the weight of pixel q for pixel p.
   *
   * @param distance mean of the distances of the values around them
   */
  float weight(int p, int q, float distance) {
    if (distance >= LARGEST) {
      return 0;
    }
    double largest = Math.max(Math.max(0, distance), featureDistance(p, q));
    if (largest >= LARGEST) {
      return 0;
    }
    // Close to exp(-distance), but with the same bits everywhere.
    double root = 1 - largest / LARGEST;
    double square = root * root;
    double fourth = square * square;
    return (float) (fourth * fourth);
  }

  private double featureDistance(int p, int q) {
    double scale = scales.feature * scales.feature;
    int count = features.channels();
    double largest = 0;
    for (int c = 0; c < count; c++) {
      double ofP = featureVariance.values()[p * count + c];
      double ofQ = featureVariance.values()[q * count + c];
      double difference = features.values()[p * count + c] - features.values()[q * count + c];
      double beyondNoise = difference * difference - (ofP + Math.min(ofP, ofQ));
      double slack = scale * (FEATURE_FLOOR + ofP + ofQ);
      // Divisions are slow, and most are not needed.
      if (beyondNoise > largest * slack) {
        largest = beyondNoise / slack;
      }
    }
    return largest;
  }
}
