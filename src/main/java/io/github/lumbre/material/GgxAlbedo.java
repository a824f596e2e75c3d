package io.github.lumbre.material;

import io.github.lumbre.math.Elementary;
import io.github.lumbre.math.Vec3;

/**
 * The directional albedo of GGX reflection with Schlick's Fresnel approximation: the fraction of
 * light from one direction that single scattering reflects. It is linear in F0 and F90, E = F0 a +
 * F90 b, so that two tables over direction and roughness suffice (Karis 2013, "Real Shading in
 * Unreal Engine 4"). Computed once, by a fixed quadrature.
 */
final class GgxAlbedo {
  private static final int SIDE = 49;

  /** Points of the quadrature over the steepness of facets, and over half of their azimuths. */
  private static final int POINTS = 48;

  private static final int AZIMUTHS = 12;
  private static final double MIN_ALPHA = 1e-3;

  /** The fourth root of {@link #MIN_ALPHA}. */
  private static final double FIRST_ROOT = Math.sqrt(Math.sqrt(MIN_ALPHA));

  private static final double[] A = new double[SIDE * SIDE];
  private static final double[] B = new double[SIDE * SIDE];
  private static final double[] MEAN_A = new double[SIDE];
  private static final double[] MEAN_B = new double[SIDE];

  static {
    for (int r = 0; r < SIDE; r++) {
      double alpha = fourthPower(FIRST_ROOT + (1 - FIRST_ROOT) * r / (SIDE - 1));
      for (int c = 0; c < SIDE; c++) {
        integrate(Math.max(1e-6, fourthPower((double) c / (SIDE - 1))), alpha, r * SIDE + c);
      }
      MEAN_A[r] = mean(A, r);
      MEAN_B[r] = mean(B, r);
    }
  }

  private GgxAlbedo() {}

  /** Columns and rows are at fourth powers: albedos change fast at small cosines and roughness. */
  private static double fourthPower(double x) {
    return x * x * x * x;
  }

  private static double fourthRoot(double x) {
    return Math.sqrt(Math.sqrt(Math.max(0, Math.min(1, x))));
  }

  private static double column(double cosine) {
    return fourthRoot(cosine) * (SIDE - 1);
  }

  private static double row(double alpha) {
    return Math.max(0, fourthRoot(alpha) - FIRST_ROOT) / (1 - FIRST_ROOT) * (SIDE - 1);
  }

  /**
   * Integrates one entry over facets m. The fraction 1 - s² of their area is less steep than a
   * facet of steepness s, so that dm = 2 s / (D cos θm) ds, which makes the integrand continuous.
   */
  private static void integrate(double cosine, double alpha, int entry) {
    Ggx facets = new Ggx(alpha);
    Vec3 wo = new Vec3(Math.sqrt((1 - cosine) * (1 + cosine)), 0, cosine);
    double visible = facets.visible(cosine);
    double a = 0;
    double b = 0;
    for (int i = 0; i < POINTS; i++) {
      // Squares, because masking changes fast where facets are steep; a sine, because the
      // integrand has an infinite slope at s = 1.
      double root = (i + .5) / POINTS;
      double s = Elementary.sinTurns(.25 * root * root);
      double rest = Elementary.cosTurns(.25 * root * root);
      double slope = alpha * rest / s;
      double up = 1 / Math.sqrt(1 + slope * slope);
      double across = slope * up;
      // Only facets up to this azimuth reflect to above the surface.
      double last = lastAzimuth(cosine * (up - .5 / up), wo.x() * across);
      for (int j = 0; j < AZIMUTHS; j++) {
        double turns = last * (j + .5) / AZIMUTHS;
        Vec3 m =
            new Vec3(across * Elementary.cosTurns(turns), across * Elementary.sinTurns(turns), up);
        double cos = Math.min(1, wo.dot(m));
        double cosI = Math.min(1, 2 * cos * up - cosine);
        if (cos > 0 && cosI > 0) {
          double weight =
              2
                  * Elementary.TWO_PI
                  * last
                  * root
                  * rest
                  * s
                  * cos
                  * facets.maskingRatio(cosine, visible, cosI)
                  / (visible * up);
          double schlick = SchlickReflection.grazing(cos);
          a += weight * (1 - schlick);
          b += weight * schlick;
        }
      }
    }
    // The quadrature may exceed the largest albedo by its error.
    double scale = 1 / Math.max(POINTS * AZIMUTHS, a + b);
    A[entry] = a * scale;
    B[entry] = b * scale;
  }

  /** Returns the azimuth in turns, at most 0.5, where b + a cos φ becomes 0. */
  private static double lastAzimuth(double b, double a) {
    if (b >= a) {
      return .5;
    }
    return b <= -a ? 0 : Elementary.atan2(Math.sqrt((a - b) * (a + b)), -b) / Elementary.TWO_PI;
  }

  /** Returns the mean over a hemisphere of uniform radiance: 2 ∫ E(μ) μ dμ. */
  private static double mean(double[] table, int row) {
    double sum = 0;
    int steps = 256;
    for (int i = 0; i < steps; i++) {
      double mu = (i + .5) / steps;
      sum += 2 * mu * interpolated(table, mu, row) / steps;
    }
    return sum;
  }

  private static double interpolated(double[] table, double cosine, int row) {
    double x = column(cosine);
    int i = Math.min(SIDE - 2, (int) x);
    double left = table[row * SIDE + i];
    return left + (x - i) * (table[row * SIDE + i + 1] - left);
  }

  private static double interpolated(double[] table, double cosine, double alpha) {
    double y = row(alpha);
    int row = Math.min(SIDE - 2, (int) y);
    double low = interpolated(table, cosine, row);
    return low + (y - row) * (interpolated(table, cosine, row + 1) - low);
  }

  private static double interpolated(double[] means, double alpha) {
    double y = row(alpha);
    int row = Math.min(SIDE - 2, (int) y);
    return means[row] + (y - row) * (means[row + 1] - means[row]);
  }

  /**
   * Returns the albedo for light from one direction.
   *
   * @param cosine between the direction and the normal, in [0,1]
   * @param alpha roughness of the distribution, in [0,1]
   */
  static double of(double f0, double f90, double cosine, double alpha) {
    return f0 * interpolated(A, cosine, alpha) + f90 * interpolated(B, cosine, alpha);
  }

  /** Returns the mean albedo under uniform radiance. */
  static double mean(double f0, double f90, double alpha) {
    return f0 * interpolated(MEAN_A, alpha) + f90 * interpolated(MEAN_B, alpha);
  }
}
