package io.github.lumbre.texture.internal;

import io.github.lumbre.math.internal.Elementary;

/**
 * Clear air around a round earth: molecules, aerosol and ozone, with the amounts along rays. An
 * amount of 1 is what lies straight above the ground. Heights and distances are in kilometers.
 * Immutable.
 */
final class Air {
  /** Molecules, in {@link #density} and other arrays of amounts. */
  static final int MOLECULES = 0;

  /** Aerosol: dust, droplets and smoke. */
  static final int AEROSOL = 1;

  /** Ozone, which absorbs and does not scatter. */
  static final int OZONE = 2;

  /** The number of constituents. */
  static final int COUNT = 3;

  static final double EARTH_RADIUS = 6371;

  /** Height of the air. */
  static final double TOP = 100;

  /** The angle between the center and the edge of the sun, in degrees. */
  static final double SUN_RADIUS_DEGREES = 180 / 676.;

  /** Ozone above the ground, as the height of its layer at sea level in cm. */
  static final double OZONE_CM = .3;

  /** The optical depth of aerosol at a wavelength of 1 µm. */
  static final double TURBIDITY = .05;

  /** The fraction of the light that aerosol scatters, of what it takes away. */
  static final double AEROSOL_ALBEDO = .9;

  /** The exponent of Ångström's law: the optical depth at 500 nm is 0.1. */
  private static final double AEROSOL_EXPONENT = -1;

  private static final double[] SCALE_HEIGHTS = {8, 1.2};
  private static final double OZONE_CENTER = 25;
  private static final double OZONE_EXTENT = 15;
  private static final double EARTH_2 = EARTH_RADIUS * EARTH_RADIUS;
  private static final double TOP_2 = (EARTH_RADIUS + TOP) * (EARTH_RADIUS + TOP);

  /** The longest way along the ground's tangent plane. */
  private static final double TANGENT = Math.sqrt(TOP_2 - EARTH_2);

  private static final int ROWS = 24;
  private static final int COLUMNS = 64;
  private static final int STEPS = 60;

  /** Amounts by height, direction and constituent. */
  private final double[][][] amounts = new double[ROWS][COLUMNS][COUNT];

  /** Tabulates the amounts. */
  Air() {
    for (int row = 0; row < ROWS; row++) {
      double tangent = TANGENT * row / (ROWS - 1);
      double radius = Math.sqrt(tangent * tangent + EARTH_2);
      double shortest = EARTH_RADIUS + TOP - radius;
      for (int column = 0; column < COLUMNS; column++) {
        double part = (double) column / (COLUMNS - 1);
        double way = shortest + part * (tangent + TANGENT - shortest);
        amounts[row][column] = integrate(radius, way);
      }
    }
  }

  /** Integrates along the ray of a length from a radius to the top. */
  private static double[] integrate(double radius, double way) {
    double[] sum = new double[COUNT];
    double[] density = new double[COUNT];
    // r² + 2 r way cos + way² = top²
    double twiceUp = way > 0 ? (TOP_2 - radius * radius) / way - way : 0;
    for (int step = 0; step < STEPS; step++) {
      double t = (step + .5) / STEPS;
      double s = way * t * t;
      density(Math.sqrt(radius * radius + s * (twiceUp + s)) - EARTH_RADIUS, density);
      for (int i = 0; i < COUNT; i++) {
        sum[i] += density[i] * way * 2 * t / STEPS;
      }
    }
    return sum;
  }

  /** Sets the densities at a height, per kilometer of the amount above the ground. */
  static void density(double height, double[] result) {
    double h = Math.max(0, height);
    for (int i = 0; i < SCALE_HEIGHTS.length; i++) {
      result[i] = Elementary.exp(-h / SCALE_HEIGHTS[i]) / SCALE_HEIGHTS[i];
    }
    double fromCenter = Math.abs(h - OZONE_CENTER) / OZONE_EXTENT;
    result[OZONE] = Math.max(0, 1 - fromCenter) / OZONE_EXTENT;
  }

  /**
   * Sets the amounts along a ray that leaves the air.
   *
   * @param height of its start, 0 to {@link #TOP}
   * @param up cosine between the ray and the vertical; below the horizon, the horizon's amounts
   */
  void along(double height, double up, double[] result) {
    double radius = EARTH_RADIUS + height;
    double tangent = Math.sqrt(Math.max(0, radius * radius - EARTH_2));
    double shortest = EARTH_RADIUS + TOP - radius;
    double across = radius * radius * (1 - up * up);
    double way = Elementary.safeSqrt(TOP_2 - across) - radius * up;
    double longest = tangent + TANGENT;
    double x = (COLUMNS - 1) * Math.min(1, Math.max(0, (way - shortest) / (longest - shortest)));
    double y = (ROWS - 1) * Math.min(1, tangent / TANGENT);
    int column = Math.min(COLUMNS - 2, (int) x);
    int row = Math.min(ROWS - 2, (int) y);
    for (int i = 0; i < COUNT; i++) {
      double[][] low = amounts[row];
      double[][] high = amounts[row + 1];
      result[i] =
          mix(
              mix(low[column][i], low[column + 1][i], x - column),
              mix(high[column][i], high[column + 1][i], x - column),
              y - row);
    }
  }

  /** Returns the value between two values. */
  static double mix(double a, double b, double part) {
    return a + part * (b - a);
  }

  /**
   * Returns the fraction of the sun's diameter that the earth does not hide.
   *
   * @param height of the place
   * @param up cosine between the vertical there and the direction to the sun's center
   */
  static double visibleSun(double height, double up) {
    double ratio = EARTH_RADIUS / (EARTH_RADIUS + height);
    double horizon = -Elementary.safeSqrt(1 - ratio * ratio);
    double diameter = 2 * Elementary.sinDegrees(SUN_RADIUS_DEGREES);
    return Math.min(1, Math.max(0, (up - horizon) / diameter + .5));
  }

  /**
   * Returns the optical depths that amounts of 1 have: of molecules by Hansen and Travis (1974, eq.
   * 2.30), of aerosol by Ångström's law, and of ozone by a Gaussian function with an error of at
   * most 0.015 / cm of Leckner's table (1978) from 450 to 700 nm. Ultraviolet light that ozone
   * absorbs is left alone.
   *
   * @param wavelength in nanometers
   */
  static double[] depths(double wavelength) {
    double micrometers = wavelength / 1000;
    double s = 1 / (micrometers * micrometers);
    double fromPeak = (wavelength - 590) / 52;
    return new double[] {
      .008569 * s * s * (1 + .0113 * s + .00013 * s * s),
      TURBIDITY * Elementary.pow(micrometers, AEROSOL_EXPONENT),
      OZONE_CM * .125 * Elementary.exp(-.5 * fromPeak * fromPeak)
    };
  }
}
