package io.github.lumbre.material.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.internal.Elementary;

/**
 * A transparent film, thinner than a few micrometers, in which light interferes: soap, oil, or
 * oxide on a metal (KHR_materials_iridescence; Belcour and Barla 2017, "A Practical Extension to
 * Microfacet Theory for the Modeling of Varying Iridescence").
 *
 * <p>It replaces the reflectance F of a surface. Let T be the light that passes the film and the
 * surface by Airy's formula, and T0 what passes the surface alone, by the exact Fresnel equations
 * for the index of refraction that F implies at normal incidence. Then F becomes 1 - (1 - F) T /
 * T0. A film that has no thickness, or the index of the outside, changes nothing.
 *
 * @param strength the part of the surface that the film covers, in [0,1]
 * @param ior index of refraction of the film, at least 1
 * @param thickness in nanometers, at least 0
 * @param outside index of refraction above the film, at least 1: that of air or of a clear coat
 */
public record ThinFilm(double strength, double ior, double thickness, double outside) {
  public static final ThinFilm NONE = new ThinFilm(0, 1, 0, 1);

  /** Largest relative amplitude of the interference of light that is left out. */
  private static final double LEAST_ECHO = 1e-6;

  /** Most reflections inside the film whose interference is computed. */
  private static final int MOST_ECHOES = 32;

  /** The largest reflectance at normal incidence of a surface whose index is used. */
  private static final double MOST_F0 = 1 - 1e-9;

  /**
   * Returns the reflectance of a facet that has the film, each component in [0,1].
   *
   * @param plain its reflectance without the film, each component in [0, f90]
   * @param f0 the same at normal incidence
   * @param f90 the same at grazing incidence; scales the effect
   * @param cosine of the angle at the facet, in air, in [0,1]
   */
  public Rgb over(Rgb plain, Rgb f0, double f90, double cosine) {
    if (strength == 0 || f90 == 0) {
      return plain;
    }
    return new Rgb(
        f90 * over(0, plain.r() / f90, ofReflectance(f0.r() / f90), cosine),
        f90 * over(1, plain.g() / f90, ofReflectance(f0.g() / f90), cosine),
        f90 * over(2, plain.b() / f90, ofReflectance(f0.b() / f90), cosine));
  }

  /** Returns the index of refraction of a dielectric in air by its F0. */
  private static double ofReflectance(double f0) {
    double root = Math.sqrt(Math.min(f0, MOST_F0));
    return (1 + root) / (1 - root);
  }

  /**
   * Returns the reflectance of the boundary of a dielectric that has the film, for one color.
   *
   * @param color 0 to 2 for red, green and blue
   * @param cosine of the angle of incidence, in [0,1]
   * @param isOutside whether the light comes from the outside, which is air
   * @param inside index of refraction of the inside, at least 1 if there is a film
   */
  public double over(int color, double cosine, boolean isOutside, double inside) {
    double plain = Fresnel.dielectric(cosine, isOutside ? inside : 1 / inside);
    if (strength == 0) {
      return plain;
    }
    double sin2 = (1 - cosine) * (1 + cosine);
    double inAir = isOutside ? cosine : Fresnel.cosTransmitted(cosine, sin2, 1 / inside);
    return over(color, plain, inside, inAir);
  }

  /**
   * Returns the reflectance of a facet that has the film, for one color.
   *
   * @param color 0 to 2 for red, green and blue
   * @param plain the facet's reflectance without the film, in [0,1]
   * @param base index of refraction of the surface, at least 1
   * @param cosine of the angle at the facet, in air, in [0,1]
   */
  private double over(int color, double plain, double base, double cosine) {
    double c = Math.min(1, cosine);
    double sin2 = (1 - c) * (1 + c);
    Side air = new Side(1, sin2);
    Side below = new Side(base, sin2);
    double alone = .5 * (passed(air.perpendicular(below)) + passed(air.parallel(below)));
    if (!(alone > 0)) {
      return plain;
    }
    Side above = new Side(outside, sin2);
    Side film = new Side(ior, sin2);
    double path = 2 * ior * thickness * film.cosine;
    double passed =
        .5
            * (passed(above.perpendicular(film), film.perpendicular(below), path, color)
                + passed(above.parallel(film), film.parallel(below), path, color));
    double covered = 1 - (1 - plain) * (passed / alone);
    return plain + strength * (Math.max(0, Math.min(1, covered)) - plain);
  }

  /** A medium, with the cosine of the angle at which light of a given sine in air travels in it. */
  private static final class Side {
    private final double index;
    private final double cosine;

    private Side(double index, double sin2InAir) {
      this.index = index;
      cosine = Elementary.safeSqrt(1 - sin2InAir / (index * index));
    }

    /**
     * Returns Fresnel's amplitude for light whose field is perpendicular to the plane of incidence.
     */
    private double perpendicular(Side other) {
      return ratio(index * cosine, other.index * other.cosine);
    }

    /** Returns Fresnel's amplitude for light whose field is in the plane of incidence. */
    private double parallel(Side other) {
      return ratio(other.index * cosine, index * other.cosine);
    }

    private static double ratio(double a, double b) {
      return a + b > 0 ? (a - b) / (a + b) : 0;
    }
  }

  private static double passed(double amplitude) {
    return (1 - amplitude) * (1 + amplitude);
  }

  /**
   * Returns the fraction of light of a color that passes the film and the surface. With q = r12 r23
   * and the phase p of a wavelength, Airy's formula is T = (1 - r12²) (1 - r23²) / |1 + q
   * exp(ip)|², and its series is (1 - r12²) (1 - r23²) / (1 - q²) · (1 + 2 Σ (-q)^m cos(mp)).
   *
   * @param upper amplitude reflected by the upper boundary of the film, r12
   * @param lower amplitude reflected by the lower one, r23
   * @param path difference of the optical paths of light reflected by both, in nanometers
   */
  private static double passed(double upper, double lower, double path, int color) {
    double q = upper * lower;
    double rest = 1 - q * q;
    if (!(rest > 0)) {
      return 0;
    }
    double sum = 1;
    double echo = -q;
    for (int m = 1; m <= MOST_ECHOES && Math.abs(echo) > LEAST_ECHO; m++) {
      sum += 2 * echo * ColorSpectrum.interference(m * path, color);
      echo *= -q;
    }
    return passed(upper) * passed(lower) / rest * sum;
  }

  /**
   * How much the red, green and blue of linear sRGB depend on each wavelength of white light (CIE
   * standard illuminant D65, CIE 1931 observer), in Fourier space: each is a sum of Gaussian
   * functions of 1 / wavelength (Belcour and Barla 2017, sec. 4). The Gaussians are fitted to the
   * CIE's tables, with an error of the transform of at most 0.02.
   */
  private static final class ColorSpectrum {
    /**
     * Share of the color, wavelength of the center in nm, and standard deviation in 1/m, of each.
     */
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
     * Returns the mean of cos(2π path / wavelength) over the light of a color: 1 without a path,
     * and about 0 beyond a few micrometers.
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
}
