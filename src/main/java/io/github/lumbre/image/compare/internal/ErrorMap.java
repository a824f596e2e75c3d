package io.github.lumbre.image.compare.internal;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.compare.PictureError;
import io.github.lumbre.math.internal.Elementary;

/**
 * A map of a picture's relative error per pixel: the root of the mean over channels of (x − r)² /
 * (r² + 0.01), on a fixed color scale.
 *
 * <p>The scale is logarithmic: black (0.001 and less), purple (0.01), orange (0.1), pale yellow (1
 * and more). Noise falls by one of these steps with 100 times as many samples.
 */
public final class ErrorMap {
  private static final double DECADES = 3;

  /** sRGB-encoded colors, evenly spaced on the scale. */
  private static final int[][] COLORS = {
    {0, 0, 4},
    {58, 12, 96},
    {133, 33, 107},
    {205, 64, 71},
    {247, 125, 21},
    {251, 188, 55},
    {252, 255, 190}
  };

  private ErrorMap() {}

  /** Returns the map of two pictures of the same size; its PNG has the colors above. */
  public static Image of(Image picture, Image reference) {
    double[] x = PictureError.seen(picture);
    double[] r = PictureError.seen(reference);
    float[] rgb = new float[x.length];
    for (int i = 0; i < x.length; i += 3) {
      double squares = 0;
      for (int c = i; c < i + 3; c++) {
        squares += (x[c] - r[c]) * (x[c] - r[c]) / (r[c] * r[c] + PictureError.FLOOR);
      }
      paint(Math.sqrt(squares / 3), rgb, i);
    }
    return new Image(picture.width(), picture.height(), rgb, new float[0]);
  }

  private static void paint(double error, float[] rgb, int at) {
    double decades = Elementary.log(Math.max(error, 1e-9)) / Elementary.log(10) + DECADES;
    HeatScale.paint(decades / DECADES, COLORS, rgb, at);
  }
}
