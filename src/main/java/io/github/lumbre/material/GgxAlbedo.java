package io.github.lumbre.material;

import io.github.lumbre.math.Elementary;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;

/**
 * The directional albedo of GGX reflection with Schlick's Fresnel approximation: the fraction of
 * light from one direction that single scattering reflects. It is linear in F0 and F90, E = F0 a +
 * F90 b, so that two tables over direction and roughness suffice (Karis 2013, "Real Shading in
 * Unreal Engine 4"). Computed once, by a fixed quadrature.
 */
final class GgxAlbedo {
  private static final int SIDE = 33;

  /** Points per side of the quadrature over random numbers. */
  private static final int POINTS = 24;

  private static final double[] A = new double[SIDE * SIDE];
  private static final double[] B = new double[SIDE * SIDE];
  private static final double[] MEAN_A = new double[SIDE];
  private static final double[] MEAN_B = new double[SIDE];

  static {
    for (int r = 0; r < SIDE; r++) {
      double roughness = (double) r / (SIDE - 1);
      for (int c = 0; c < SIDE; c++) {
        integrate(cosine(c), Math.max(1e-3, roughness * roughness), r * SIDE + c);
      }
      MEAN_A[r] = mean(A, r);
      MEAN_B[r] = mean(B, r);
    }
  }

  private GgxAlbedo() {}

  /** Returns the cosine of a column: squares, because albedos change fast at grazing angles. */
  private static double cosine(int column) {
    double x = (double) column / (SIDE - 1);
    return Math.max(1e-4, x * x);
  }

  /** Integrates one entry by sampling visible normals. */
  private static void integrate(double cosine, double alpha, int entry) {
    Ggx facets = new Ggx(alpha);
    Vec3 wo = new Vec3(Math.sqrt((1 - cosine) * (1 + cosine)), 0, cosine);
    double a = 0;
    double b = 0;
    for (int i = 0; i < POINTS; i++) {
      for (int j = 0; j < POINTS; j++) {
        Vec3 m = facets.sampleVisible(wo, new Point2((i + .5) / POINTS, (j + .5) / POINTS));
        double cos = Math.min(1, wo.dot(m));
        Vec3 wi = m.times(2 * cos).minus(wo);
        if (wi.z() > 0) {
          double weight = facets.maskingRatio(cosine, Math.min(1, wi.z()));
          double schlick = SchlickReflection.grazing(cos);
          a += weight * (1 - schlick);
          b += weight * schlick;
        }
      }
    }
    A[entry] = a / (POINTS * POINTS);
    B[entry] = b / (POINTS * POINTS);
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
    double x = Math.sqrt(Math.min(1, cosine)) * (SIDE - 1);
    int i = Math.min(SIDE - 2, (int) x);
    double left = table[row * SIDE + i];
    return left + (x - i) * (table[row * SIDE + i + 1] - left);
  }

  private static double interpolated(double[] table, double cosine, double alpha) {
    double y = Elementary.safeSqrt(alpha) * (SIDE - 1);
    int row = Math.min(SIDE - 2, (int) y);
    double low = interpolated(table, cosine, row);
    return low + (y - row) * (interpolated(table, cosine, row + 1) - low);
  }

  private static double interpolated(double[] means, double alpha) {
    double y = Elementary.safeSqrt(alpha) * (SIDE - 1);
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
