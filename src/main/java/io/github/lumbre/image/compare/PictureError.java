package io.github.lumbre.image.compare;

import io.github.lumbre.image.Image;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * The error of a picture against a reference, over all pixels and channels of linear light unless
 * stated otherwise.
 *
 * @param rmse root of the mean squared error
 * @param relativeMse mean of (x − r)² / (r² + 0.01), where r is the reference
 * @param bias mean of x − r
 * @param percentile999 99.9th percentile of the absolute error
 * @param largest largest absolute error
 * @param ssim mean structural similarity of encoded luminance; 1 for identical pictures
 * @param flip mean of LDR-FLIP; 0 for identical pictures
 */
public record PictureError(
    double rmse,
    double relativeMse,
    double bias,
    double percentile999,
    double largest,
    double ssim,
    double flip) {
  /**
   * A summand of the denominator of relative errors that limits the weight of dark pixels; in units
   * of squared linear light.
   */
  public static final double FLOOR = .01;

  /**
   * Compares a picture with a reference.
   *
   * @throws IllegalArgumentException if their sizes differ
   */
  public static PictureError of(Image picture, Image reference) {
    Flip.requireSameSize(picture, reference);
    double[] x = seen(picture);
    double[] r = seen(reference);
    double squares = 0;
    double relative = 0;
    double signed = 0;
    double[] absolute = new double[x.length];
    for (int i = 0; i < x.length; i++) {
      double error = x[i] - r[i];
      squares += error * error;
      relative += error * error / (r[i] * r[i] + FLOOR);
      signed += error;
      absolute[i] = Math.abs(error);
    }
    Arrays.sort(absolute);
    return new PictureError(
        Math.sqrt(squares / x.length),
        relative / x.length,
        signed / x.length,
        absolute[(int) Math.ceil(.999 * absolute.length) - 1],
        absolute[absolute.length - 1],
        Ssim.of(picture, reference),
        Flip.mean(picture, reference));
  }

  /** Returns a picture's values over black, three per pixel. */
  public static double[] seen(Image image) {
    double[] values = new double[image.rgb().length];
    for (int i = 0; i < values.length; i++) {
      int pixel = i / 3;
      values[i] =
          (double) image.rgb()[i] * image.alpha(pixel % image.width(), pixel / image.width());
    }
    return values;
  }

  /** Returns all metrics by the names under which they are printed, in order. */
  public Map<String, Double> byName() {
    Map<String, Double> figures = new LinkedHashMap<>();
    figures.put("rmse", rmse);
    figures.put("relmse", relativeMse);
    figures.put("bias", bias);
    figures.put("p99.9", percentile999);
    figures.put("max", largest);
    figures.put("ssim", ssim);
    figures.put("flip", flip);
    return figures;
  }
}
