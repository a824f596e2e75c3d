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
 * @param colorScale larger values make more pixels similar
 * @param featureScale larger values make more pixels similar
 */
record Similarity(
    Raster color,
    Raster variance,
    Raster features,
    Raster featureVariance,
    double colorScale,
    double featureScale) {
  private static final int PATCH = 2;

  /** Differences of this share of the color do not count. */
  private static final float COLOR_FLOOR = 1e-4f;

  private static final double FEATURE_FLOOR = 1e-3;

  /** Distances beyond this one have weight 0. */
  private static final double LARGEST = 8;

  /** Returns the weight of pixel q for pixel p. */
  double weight(int px, int py, int qx, int qy) {
    double ofFeatures = featureDistance(py * color.width() + px, qy * color.width() + qx);
    if (ofFeatures >= LARGEST) {
      return 0;
    }
    double distance = Math.max(ofFeatures, colorDistance(px, py, qx, qy));
    if (distance >= LARGEST) {
      return 0;
    }
    // Close to exp(-distance), but with the same bits everywhere.
    double root = 1 - distance / LARGEST;
    double square = root * root;
    double fourth = square * square;
    return fourth * fourth;
  }

  private double featureDistance(int p, int q) {
    double scale = featureScale * featureScale;
    int count = features.channels();
    double largest = 0;
    for (int c = 0; c < count; c++) {
      double ofP = featureVariance.values()[p * count + c];
      double ofQ = featureVariance.values()[q * count + c];
      double difference = features.values()[p * count + c] - features.values()[q * count + c];
      double beyondNoise = difference * difference - (ofP + Math.min(ofP, ofQ));
      largest = Math.max(largest, beyondNoise / (scale * (FEATURE_FLOOR + ofP + ofQ)));
    }
    return largest;
  }

  private double colorDistance(int px, int py, int qx, int qy) {
    int width = color.width();
    int height = color.height();
    int left = -Math.min(PATCH, Math.min(px, qx));
    int right = Math.min(PATCH, width - 1 - Math.max(px, qx));
    int top = -Math.min(PATCH, Math.min(py, qy));
    int bottom = Math.min(PATCH, height - 1 - Math.max(py, qy));
    float scale = (float) (colorScale * colorScale);
    float[] values = color.values();
    float[] variances = variance.values();
    int count = 3 * (right - left + 1) * (bottom - top + 1);
    // No summand is below -1/scale: noise explains at most all of a difference.
    double farthest = count * (LARGEST + 1 / scale);
    double sum = 0;
    for (int y = top; y <= bottom && sum < farthest; y++) {
      int i = 3 * ((py + y) * width + px + left);
      int shift = 3 * ((qy - py) * width + qx - px);
      for (int end = i + 3 * (right - left + 1); i < end; i++) {
        float a = values[i];
        float b = values[i + shift];
        float ofA = variances[i];
        float ofB = variances[i + shift];
        float difference = a - b;
        float beyondNoise = difference * difference - (ofA + Math.min(ofA, ofB));
        sum += beyondNoise / (COLOR_FLOOR * (1 + a * a + b * b) + scale * (ofA + ofB));
      }
    }
    return Math.max(0, sum / count);
  }
}
