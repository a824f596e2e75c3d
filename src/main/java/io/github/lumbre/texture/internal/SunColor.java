package io.github.lumbre.texture.internal;

import io.github.lumbre.math.internal.Elementary;

/** The spectrum of the sun outside the air, and the colors of its wavelengths. Stateless. */
final class SunColor {
  /** Irradiance of the sun outside the air, in W/m². */
  static final double SOLAR_CONSTANT = 1361;

  /** Kelvins of a black body with the sun's power. */
  private static final double TEMPERATURE = 5772;

  /** The second radiation constant, in nm K. */
  private static final double C2 = 1.438776877e7;

  /** Height, center in nm, and widths below and above it of the lobes of x, y and z. */
  private static final double[][][] LOBES = {
    {{.362, 442, 16, 26.7}, {1.056, 599.8, 37.9, 31}, {-.065, 501.1, 20.4, 26.2}},
    {{.821, 568.8, 46.9, 40.5}, {.286, 530.9, 16.3, 31.1}},
    {{1.217, 437, 11.8, 36}, {.681, 459, 26, 13.8}}
  };

  private static final double[][] SRGB = {
    {3.2404542, -1.5371385, -.4985314},
    {-.9692660, 1.8760108, .0415560},
    {.0556434, -.2040259, 1.0572252}
  };

  private SunColor() {}

  /**
   * Returns the irradiance of a wavelength in nanometers outside the air, in W/m²/nm: a black
   * body's.
   */
  static double irradiance(double wavelength) {
    double x = C2 / (wavelength * TEMPERATURE);
    double piSquared = Math.PI * Math.PI;
    double share = 15 / (piSquared * piSquared) * x * x * x * x / Elementary.expm1(x);
    return SOLAR_CONSTANT * share / wavelength;
  }

  /**
   * Returns the linear red, green and blue of each wavelength of the sun's light. The CIE's 1931
   * observer is a sum of Gaussian functions (Wyman, Sloan and Shirley 2013, table 1).
   *
   * @param wavelengths in nanometers, evenly spaced
   * @param spacing of the wavelengths
   * @param luminance of the sum of all
   */
  static double[][] weights(double[] wavelengths, double spacing, double luminance) {
    double[][] result = new double[3][wavelengths.length];
    double whole = 0;
    for (int i = 0; i < wavelengths.length; i++) {
      double light = irradiance(wavelengths[i]) * spacing;
      for (int axis = 0; axis < LOBES.length; axis++) {
        double value = light * observer(axis, wavelengths[i]);
        whole += axis == 1 ? value : 0;
        for (int channel = 0; channel < result.length; channel++) {
          result[channel][i] += SRGB[channel][axis] * value;
        }
      }
    }
    for (double[] channel : result) {
      for (int i = 0; i < channel.length; i++) {
        channel[i] *= luminance / whole;
      }
    }
    return result;
  }

  private static double observer(int axis, double wavelength) {
    double sum = 0;
    for (double[] lobe : LOBES[axis]) {
      double t = (wavelength - lobe[1]) / (wavelength < lobe[1] ? lobe[2] : lobe[3]);
      sum += lobe[0] * Elementary.exp(-.5 * t * t);
    }
    return sum;
  }
}
