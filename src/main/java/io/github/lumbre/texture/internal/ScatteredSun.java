package io.github.lumbre.texture.internal;

import io.github.lumbre.math.internal.Elementary;

/**
 * Sunlight that clear air scatters to the ground, by wavelength and for an irradiance of 1 outside
 * the air. Light that is scattered once is integrated along each ray. Light that is scattered more
 * often is taken to come from all directions alike, in a geometric series (Hillaire 2020, "A
 * Scalable and Production Ready Sky and Atmosphere Rendering Technique", sec. 5.5). Immutable but
 * for the memory of one ray: confined to one thread.
 */
final class ScatteredSun {
  /** Reflectance of the ground, which lights the air from below. */
  static final double GROUND = .3;

  private static final int HEIGHTS = 10;
  private static final int SUNS = 20;

  /** The lowest sun in the table of light that is scattered often, as a cosine. */
  private static final double LOWEST = -.2;

  private static final int RISES = 8;
  private static final int TURNS = 4;
  private static final int STEPS = 40;
  private static final int SHORT_STEPS = 12;

  private final Air air;
  private final double sunUp;
  private final double[][] depths;
  private final double[][] scattering;

  /** Light that was scattered or reflected before, by wavelength, height and sun. */
  private final double[][][] often;

  private final AirRay ray;

  /**
   * Prepares the light.
   *
   * @param wavelengths in nanometers
   * @param elevation of the sun in degrees
   */
  ScatteredSun(Air air, double[] wavelengths, double elevation) {
    this.air = air;
    sunUp = Elementary.sinDegrees(elevation);
    depths = new double[wavelengths.length][];
    scattering = new double[wavelengths.length][];
    for (int i = 0; i < wavelengths.length; i++) {
      depths[i] = Air.depths(wavelengths[i]);
      scattering[i] = depths[i].clone();
      scattering[i][Air.AEROSOL] *= Air.AEROSOL_ALBEDO;
      scattering[i][Air.OZONE] = 0;
    }
    ray = new AirRay(air, STEPS);
    often = new double[wavelengths.length][HEIGHTS][SUNS];
    for (int height = 0; height < HEIGHTS; height++) {
      for (int sun = 0; sun < SUNS; sun++) {
        tabulate(height, sun);
      }
    }
  }

  private void tabulate(int row, int column) {
    double root = (double) row / (HEIGHTS - 1);
    double sun = LOWEST + (1 - LOWEST) * column / (SUNS - 1);
    double[] light = new double[depths.length];
    double[] kept = new double[depths.length];
    AirRay around = new AirRay(air, SHORT_STEPS);
    for (int rise = 0; rise < RISES; rise++) {
      double up = (2 * rise + 1.) / RISES - 1;
      for (int turn = 0; turn < TURNS; turn++) {
        around.trace(Air.TOP * root * root, up, Elementary.cosTurns((turn + .5) / TURNS / 2), sun);
        for (int i = 0; i < depths.length; i++) {
          gather(around, i, light, kept);
        }
      }
    }
    int rays = RISES * TURNS;
    for (int i = 0; i < depths.length; i++) {
      often[i][row][column] = light[i] / rays / (1 - kept[i] / rays);
    }
  }

  /** Adds the light of a ray that is scattered once, and the part of even light that it keeps. */
  private void gather(AirRay around, int color, double[] light, double[] kept) {
    for (int step = 0; step < around.steps; step++) {
      double matter = dot(scattering[color], around.inside[step]);
      double through = matter * passed(color, around.before[step]);
      kept[color] += through;
      light[color] +=
          through * around.sun[step] * passed(color, around.toSun[step]) / (4 * Math.PI);
    }
    if (around.isOnGround) {
      double[] toSun = new double[Air.COUNT];
      air.along(0, around.sunUpAtEnd, toSun);
      double irradiance = Math.max(0, around.sunUpAtEnd) * passed(color, toSun);
      light[color] += GROUND / Math.PI * irradiance * passed(color, around.whole);
    }
  }

  private static double dot(double[] a, double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  private double passed(int color, double[] amounts) {
    return Elementary.exp(-dot(depths[color], amounts));
  }

  /** Returns the irradiance at normal incidence that reaches the ground directly. */
  double direct(int color) {
    double[] toSun = new double[Air.COUNT];
    air.along(0, sunUp, toSun);
    return Air.visibleSun(0, sunUp) * passed(color, toSun);
  }

  /**
   * Adds the light that arrives on the ground from a direction in the sky.
   *
   * @param up sine of the direction's elevation
   * @param towards cosine of the horizontal angle to the sun
   * @param result by wavelength: {light scattered once by molecules and by aerosol, both to be
   *     multiplied by the phase function, and light scattered often}
   */
  void add(double up, double towards, double[][] result) {
    ray.trace(0, up, towards, sunUp);
    for (int step = 0; step < ray.steps; step++) {
      double[] inside = ray.inside[step];
      for (int i = 0; i < depths.length; i++) {
        double[] scatters = scattering[i];
        double through = passed(i, ray.before[step]);
        double once = through * ray.sun[step] * passed(i, ray.toSun[step]);
        result[i][0] += once * scatters[0] * inside[0];
        result[i][1] += once * scatters[1] * inside[1];
        result[i][2] += through * dot(scatters, inside) * often(i, step);
      }
    }
  }

  private double often(int color, int step) {
    double y = (HEIGHTS - 1) * Math.sqrt(ray.height[step] / Air.TOP);
    double x = (SUNS - 1) * Math.max(0, (ray.sunUp[step] - LOWEST) / (1 - LOWEST));
    int row = Math.min(HEIGHTS - 2, (int) y);
    int column = Math.min(SUNS - 2, (int) x);
    double[][] table = often[color];
    return Air.mix(
        Air.mix(table[row][column], table[row][column + 1], x - column),
        Air.mix(table[row + 1][column], table[row + 1][column + 1], x - column),
        y - row);
  }

  /** Returns the density per solid angle with which molecules scatter light by an angle. */
  static double molecules(double cosine) {
    return 3 / (16 * Math.PI) * (1 + cosine * cosine);
  }

  /** Returns the density per solid angle with which aerosol scatters light by an angle. */
  static double aerosol(double cosine) {
    double g = .7;
    double s = 1 + g * g - 2 * g * cosine;
    return (1 - g * g) / (4 * Math.PI * s * Math.sqrt(s));
  }
}
