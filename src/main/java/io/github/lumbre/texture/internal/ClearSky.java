package io.github.lumbre.texture.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.texture.Texture;

/**
 * The sky of a clear day without the sun's disk, above gray ground. It has the coordinates of a
 * latitude-longitude image: u = 0.5 is forward, v = 1 is up. A radiance of 1 stands for {@value
 * #WATTS} W/m²/sr of the sun's whole spectrum, so that white ground at noon is about 1. Immutable.
 */
public final class ClearSky implements Texture<Rgb> {
  /** Watts per square meter of the sun's whole spectrum for an irradiance of luminance 1. */
  public static final double WATTS = 340.25;

  /** The resolution at which the sky can be tabulated. */
  public static final int COLUMNS = 256;

  /** The number of rows that belongs to {@link #COLUMNS}. */
  public static final int ROWS = 128;

  /** The lowest elevation of the sun's center, in degrees: twilight needs finer tables. */
  public static final double LOWEST = 0;

  /** Where the sun stands if nothing else is said, in degrees: to the left in front. */
  public static final double AZIMUTH = -40;

  /** How high the sun stands if nothing else is said, in degrees. */
  public static final double ELEVATION = 35;

  private static final double SHORTEST = 385;
  private static final double SPACING = 30;
  private static final int COLORS = 12;
  private static final int AZIMUTHS = 8;
  private static final int ELEVATIONS = 32;
  private static final int PARTS = 3;

  private final double sunTurns;
  private final double sunSine;
  private final double sunCosine;
  private final double[][] toRgb;

  /** Light before phase functions: red, green and blue of each part, by azimuth and elevation. */
  private final double[][][] table = new double[AZIMUTHS + 1][ELEVATIONS + 1][];

  private final Rgb sun;
  private final Rgb ground;

  /**
   * Computes a sky.
   *
   * @param azimuth of the sun in degrees: 0 behind, 90 to the right of the forward direction
   * @param elevation of the sun's center in degrees, 0 to 90
   */
  public ClearSky(double azimuth, double elevation) {
    if (!(Double.isFinite(azimuth) && elevation >= LOWEST && elevation <= 90)) {
      throw new IllegalArgumentException(
          "sun: expected an elevation from 0 to 90, found " + azimuth + "," + elevation);
    }
    sunTurns = .5 - azimuth / 360;
    sunSine = Elementary.sinDegrees(elevation);
    sunCosine = Elementary.cosDegrees(elevation);
    double[] wavelengths = new double[COLORS];
    for (int i = 0; i < COLORS; i++) {
      wavelengths[i] = SHORTEST + SPACING * i;
    }
    toRgb = SunColor.weights(wavelengths, SPACING, SunColor.SOLAR_CONSTANT / WATTS);
    ScatteredSun light = new ScatteredSun(new Air(), wavelengths, elevation);
    for (int i = 0; i <= AZIMUTHS; i++) {
      for (int j = 0; j <= ELEVATIONS; j++) {
        table[i][j] = parts(light, i, j);
      }
    }
    double[] direct = new double[3];
    for (int i = 0; i < COLORS; i++) {
      addColor(i, light.direct(i), direct, 0);
    }
    sun = color(direct[0], direct[1], direct[2]);
    ground =
        sun.times(Math.max(0, sunSine))
            .plus(horizontalIrradiance())
            .times(ScatteredSun.GROUND / Math.PI);
  }

  private double[] parts(ScatteredSun light, int azimuth, int elevation) {
    double root = (double) elevation / ELEVATIONS;
    double[][] spectrum = new double[COLORS][PARTS];
    light.add(
        Elementary.sinTurns(root * root / 4),
        Elementary.cosTurns((double) azimuth / AZIMUTHS / 2),
        spectrum);
    double[] result = new double[3 * PARTS];
    for (int i = 0; i < COLORS; i++) {
      for (int part = 0; part < PARTS; part++) {
        addColor(i, spectrum[i][part], result, 3 * part);
      }
    }
    return result;
  }

  private void addColor(int wavelength, double light, double[] to, int at) {
    for (int channel = 0; channel < 3; channel++) {
      to[at + channel] += light * toRgb[channel][wavelength];
    }
  }

  private static Rgb color(double r, double g, double b) {
    return new Rgb(Math.max(0, r), Math.max(0, g), Math.max(0, b));
  }

  /**
   * Returns the direction to the sun's center.
   *
   * @param axes directions of the sky's right, up and forward axes in world space
   */
  public Vec3 toSun(Frame axes) {
    return axes.toWorld(
        new Vec3(
            sunCosine * Elementary.sinTurns(sunTurns),
            sunSine,
            sunCosine * Elementary.cosTurns(sunTurns)));
  }

  /** Returns the sun's irradiance at normal incidence; black if it is below the horizon. */
  public Rgb sun() {
    return sun;
  }

  /** Returns the irradiance of level ground from the sky without the sun. */
  Rgb horizontalIrradiance() {
    int rows = 32;
    int columns = 48;
    Rgb sum = Rgb.BLACK;
    for (int row = 0; row < rows; row++) {
      // The squares of sines are evenly spaced: each direction has the same weight.
      double sine = Math.sqrt((row + .5) / rows);
      double elevation = Elementary.asin(sine) / Elementary.TWO_PI;
      for (int column = 0; column < columns; column++) {
        sum = sum.plus(at((column + .5) / columns, .5 + 2 * elevation));
      }
    }
    return sum.times(Math.PI / (rows * columns));
  }

  @Override
  public Rgb at(double u, double v) {
    double elevation = 2 * Math.min(1, v) - 1;
    if (elevation < 0) {
      return ground;
    }
    double turns = u - .5 - sunTurns;
    double aside = Math.abs(turns - Math.rint(turns));
    double sine = Elementary.sinTurns(elevation / 4);
    double horizontal = Elementary.cosTurns(elevation / 4);
    double cosine = sine * sunSine + horizontal * sunCosine * Elementary.cosTurns(aside);
    double x = 2 * AZIMUTHS * aside;
    double y = ELEVATIONS * Math.sqrt(elevation);
    int column = Math.min(AZIMUTHS - 1, (int) x);
    int row = Math.min(ELEVATIONS - 1, (int) y);
    double[][] left = table[column];
    double[][] right = table[column + 1];
    double molecules = ScatteredSun.molecules(cosine);
    double aerosol = ScatteredSun.aerosol(cosine);
    double[] rgb = new double[3];
    for (int i = 0; i < rgb.length; i++) {
      rgb[i] =
          molecules * at(left, right, x - column, row, y - row, i)
              + aerosol * at(left, right, x - column, row, y - row, 3 + i)
              + at(left, right, x - column, row, y - row, 6 + i);
    }
    return color(rgb[0], rgb[1], rgb[2]);
  }

  private static double at(
      double[][] left, double[][] right, double x, int row, double y, int value) {
    return Air.mix(
        Air.mix(left[row][value], left[row + 1][value], y),
        Air.mix(right[row][value], right[row + 1][value], y),
        x);
  }
}
