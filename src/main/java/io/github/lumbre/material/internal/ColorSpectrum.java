package io.github.lumbre.material.internal;

import io.github.lumbre.math.internal.Elementary;

/**
 * How much the red, green and blue of linear sRGB depend on each wavelength of white light (CIE
 * standard illuminant D65, CIE 1931 observer), in Fourier space: each is a sum of Gaussian
 * functions of 1 / wavelength (Belcour and Barla 2017, sec. 4). The Gaussians are fitted to the
 * CIE's tables, with an error of the transform of at most 0.02.
 */
final class ColorSpectrum {
  /** Share of the color, wavelength of the center in nm, and standard deviation in 1/m, of each. */
  private static final double[][][] GAUSSIANS = {
    {
      {.08983, 440.414, 77222}, {-1.50005, 552.798, 148136},
      {1.99364, 590.896, 101054}, {.41654, 612.310, 55265}
    },
    {{-.09059, 442.564, 80164}, {-.17124, 612.09, 68010}, {1.26185, 543.272, 113931}},
    {{-.12923, 555.106, 100277}, {1.12926, 453.113, 104115}}
  };

  /** Distance of the table's rows, in nanometers. */
  private static final double STEP = 4;

  /** Number of rows. Light whose paths differ by more than 16 µm does not interfere. */
  private static final int ROWS = 4000;

  private static final double[][] TABLES = new double[GAUSSIANS.length][ROWS + 1];

  static {
    for (int color = 0; color < TABLES.length; color++) {
      double whole = transform(color, 0);
      for (int row = 0; row < ROWS; row++) {
        TABLES[color][row] = transform(color, STEP * row) / whole;
      }
    }
  }

  private ColorSpectrum() {}

  private static double transform(int color, double path) {
    double sum = 0;
    for (double[] gaussian : GAUSSIANS[color]) {
      double spread = Math.PI * gaussian[2] * 1e-9 * path;
      double turns = path / gaussian[1];
      sum += gaussian[0] * Elementary.cosTurns(turns) * Elementary.exp(-2 * spread * spread);
    }
    return sum;
  }

  /**
   * Returns the mean of cos(2π path / wavelength) over the light of a color: 1 without a path, and
   * about 0 beyond a few micrometers.
   *
   * @param path in nanometers, at least 0
   * @param color 0 to 2 for red, green and blue
   */
  static double interference(double path, int color) {
    double x = path / STEP;
    if (!(x < ROWS)) {
      return 0;
    }
    int row = (int) x;
    double[] table = TABLES[color];
    return table[row] + (x - row) * (table[row + 1] - table[row]);
  }
}
