package io.github.lumbre.render.denoise;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;

/**
 * Separates a denoised picture from the light of its background, as matting does. The coverage of
 * few samples is coarse, and does not fit light that was filtered with its neighbors. At edges, it
 * is replaced by the one for which the color is that of covered neighbors, so that both together
 * give the filtered light. Stateless.
 */
final class EdgeCoverage {
  /** Colors that differ by less than this share from the background tell nothing of coverage. */
  private static final double LEAST_CONTRAST = .05;

  /** The least coverage of a pixel that a sample covers. */
  private static final double LEAST = 1 / 256.;

  private final int width;
  private final int height;
  private final float[] light;
  private final float[] sampled;
  private final double[] behind;

  private EdgeCoverage(int width, int height, float[] light, float[] sampled, Rgb background) {
    this.width = width;
    this.height = height;
    this.light = light;
    this.sampled = sampled;
    behind = new double[] {background.r(), background.g(), background.b()};
  }

  /**
   * Returns the picture with straight alpha.
   *
   * @param light with that of the background, three values for each pixel
   * @param sampled the share of each pixel's samples that cover it; where it is 0 or 1, it stays
   * @param background light where nothing is covered
   */
  static Image separated(int width, int height, float[] light, float[] sampled, Rgb background) {
    return new EdgeCoverage(width, height, light, sampled, background).picture();
  }

  private Image picture() {
    float[] rgb = new float[light.length];
    float[] alpha = sampled.clone();
    double[] near = new double[3];
    for (int pixel = 0; pixel < alpha.length; pixel++) {
      if (alpha[pixel] > 0 && alpha[pixel] < 1 && findNear(pixel, near)) {
        alpha[pixel] = (float) coverage(pixel, near);
      }
      for (int c = 0; c < 3 && alpha[pixel] > 0; c++) {
        double own = Math.max(0, light[3 * pixel + c]) - (1 - alpha[pixel]) * behind[c];
        rgb[3 * pixel + c] = (float) Math.min(Float.MAX_VALUE, Math.max(0, own / alpha[pixel]));
      }
    }
    return new Image(width, height, rgb, alpha);
  }

  /**
   * Finds the mean light of a pixel's neighbors that are wholly covered. Returns whether there are
   * some, and they differ from the background.
   */
  private boolean findNear(int pixel, double[] near) {
    int count = 0;
    near[0] = 0;
    near[1] = 0;
    near[2] = 0;
    int column = pixel % width;
    int row = pixel / width;
    for (int y = Math.max(0, row - 1); y <= Math.min(height - 1, row + 1); y++) {
      for (int x = Math.max(0, column - 1); x <= Math.min(width - 1, column + 1); x++) {
        if (sampled[y * width + x] == 1) {
          count++;
          for (int c = 0; c < 3; c++) {
            near[c] += light[3 * (y * width + x) + c];
          }
        }
      }
    }
    double contrast = 0;
    double size = 0;
    for (int c = 0; c < 3 && count > 0; c++) {
      near[c] /= count;
      contrast += (behind[c] - near[c]) * (behind[c] - near[c]);
      size += Math.max(behind[c], near[c]) * Math.max(behind[c], near[c]);
    }
    return contrast > LEAST_CONTRAST * LEAST_CONTRAST * size;
  }

  /** Returns the coverage by a color that gives a pixel's light, as nearly as possible. */
  private double coverage(int pixel, double[] color) {
    double along = 0;
    double length = 0;
    for (int c = 0; c < 3; c++) {
      along += (behind[c] - light[3 * pixel + c]) * (behind[c] - color[c]);
      length += (behind[c] - color[c]) * (behind[c] - color[c]);
    }
    return Math.max(LEAST, Math.min(1, along / length));
  }
}
