package io.github.lumbre.denoise;

import java.util.Arrays;

/**
 * Limits pixels of half pictures that are far brighter than all around them: rare paths of much
 * light, which no neighborhood explains. Their light is lost.
 */
final class Spikes {
  private static final double FLOOR = 1e-3;

  private Spikes() {}

  /**
   * Returns two half pictures without spikes: at most as bright as the second brightest of 16
   * neighbors in both, or as twice the same pixel of the other half.
   */
  static Estimates limited(Estimates halves) {
    Raster first = limited(halves.first(), halves.second());
    Raster second = limited(halves.second(), halves.first());
    return new Estimates(first, second);
  }

  private static Raster limited(Raster half, Raster other) {
    Raster result = half.times(1);
    float[] near = new float[16];
    for (int i = 0; i < half.pixels(); i++) {
      int count = neighbors(half, i, near, 0);
      count = neighbors(other, i, near, count);
      Arrays.sort(near, 0, count);
      double around = count < 2 ? Double.POSITIVE_INFINITY : near[count - 2] + FLOOR;
      double limit = Math.max(around, 2 * brightness(other, i));
      double found = brightness(half, i);
      if (found > limit) {
        for (int c = 0; c < 3; c++) {
          result.values()[3 * i + c] *= (float) (limit / found);
        }
      }
    }
    return result;
  }

  private static int neighbors(Raster half, int pixel, float[] near, int before) {
    int x = pixel % half.width();
    int y = pixel / half.width();
    int count = before;
    for (int qy = Math.max(0, y - 1); qy <= Math.min(half.height() - 1, y + 1); qy++) {
      for (int qx = Math.max(0, x - 1); qx <= Math.min(half.width() - 1, x + 1); qx++) {
        if (qx != x || qy != y) {
          near[count++] = brightness(half, qy * half.width() + qx);
        }
      }
    }
    return count;
  }

  private static float brightness(Raster half, int pixel) {
    float sum = 0;
    for (int c = 0; c < 3; c++) {
      sum += Math.max(0, half.values()[3 * pixel + c]);
    }
    return sum / 3;
  }
}
