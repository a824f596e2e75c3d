package io.github.lumbre.material;

import io.github.lumbre.material.internal.Ggx;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import java.nio.ByteBuffer;
import java.util.function.IntToDoubleFunction;

/** Computes the tables of {@link GgxAlbedo} by a fixed quadrature. */
final class GgxAlbedoQuadrature {
  private static final int SIDE = GgxAlbedo.SIDE;

  /** Points of the quadrature over the steepness of facets, and over half of their azimuths. */
  private static final int POINTS = 48;

  private static final int AZIMUTHS = 12;

  private final double[] a = new double[SIDE * SIDE];
  private final double[] b = new double[SIDE * SIDE];

  private GgxAlbedoQuadrature() {
    for (int row = 0; row < SIDE; row++) {
      for (int column = 0; column < SIDE; column++) {
        integrate(GgxAlbedo.cosine(column), GgxAlbedo.alpha(row), row * SIDE + column);
      }
    }
  }

  /** Returns the contents of the resource. */
  static byte[] table() {
    GgxAlbedoQuadrature computed = new GgxAlbedoQuadrature();
    ByteBuffer bytes = ByteBuffer.allocate(2 * SIDE * (SIDE + 1) * Double.BYTES);
    put(bytes, SIDE * SIDE, i -> computed.a[i]);
    put(bytes, SIDE * SIDE, i -> computed.b[i]);
    put(bytes, SIDE, row -> mean(computed.a, row));
    put(bytes, SIDE, row -> mean(computed.b, row));
    return bytes.array();
  }

  private static void put(ByteBuffer bytes, int count, IntToDoubleFunction value) {
    for (int i = 0; i < count; i++) {
      bytes.putDouble(value.applyAsDouble(i));
    }
  }

  /**
   * Integrates one entry over facets m. The fraction 1 - s² of their area is less steep than a
   * facet of steepness s, so that dm = 2 s / (D cos θm) ds, which makes the integrand continuous.
   */
  private void integrate(double cosine, double alpha, int entry) {
    Ggx facets = new Ggx(alpha);
    Vec3 wo = new Vec3(Math.sqrt((1 - cosine) * (1 + cosine)), 0, cosine);
    double visible = facets.visible(cosine);
    double sumA = 0;
    double sumB = 0;
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
          sumA += weight * (1 - schlick);
          sumB += weight * schlick;
        }
      }
    }
    // The quadrature may exceed the largest albedo by its error.
    double scale = 1 / Math.max(POINTS * AZIMUTHS, sumA + sumB);
    a[entry] = sumA * scale;
    b[entry] = sumB * scale;
  }

  /** Returns the azimuth in turns, at most 0.5, where b + a cos φ becomes 0. */
  static double lastAzimuth(double b, double a) {
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
      sum += 2 * mu * GgxAlbedo.interpolated(table, mu, row) / steps;
    }
    return sum;
  }
}
