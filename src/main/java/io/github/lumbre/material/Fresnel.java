package io.github.lumbre.material;

import io.github.lumbre.math.Elementary;

/** How much a smooth boundary between two dielectrics reflects. */
public final class Fresnel {
  private Fresnel() {}

  /**
   * Returns the share of unpolarised light that is reflected, exactly (PBRT 4e, eq. 9.6): 0 if eta
   * is 1, and 1 beyond the critical angle.
   *
   * @param cosI cosine of the angle of incidence, in [0,1]
   * @param eta index of refraction behind the boundary over the one before it, in [1e-150, 1e150]
   */
  public static double dielectric(double cosI, double eta) {
    if (eta == 1) {
      return 0;
    }
    double sin2I = (1 - cosI) * (1 + cosI);
    double cosT = cosTransmitted(cosI, sin2I, eta);
    if (cosT == 0) {
      return 1;
    }
    double contrast = (eta - 1) * (eta + 1);
    double parallel = ratio(eta * cosI, cosT, contrast * (cosI * cosI - sin2I / (eta * eta)));
    double perpendicular = ratio(eta * cosT, cosI, contrast);
    return Math.min(1, .5 * (parallel * parallel + perpendicular * perpendicular));
  }

  /**
   * Returns (a − b)/(a + b).
   *
   * @param squares a² − b²; takes the place of a − b where that cancels, as it does if η is near 1
   */
  private static double ratio(double a, double b, double squares) {
    double difference = a - b;
    double sum = a + b;
    return Math.abs(difference) > .1 * sum ? difference / sum : squares / (sum * sum);
  }

  /**
   * Returns the cosine of the refracted angle, or 0 where there is only reflection.
   *
   * @param sin2I the square of the sine that belongs to cosI
   */
  static double cosTransmitted(double cosI, double sin2I, double eta) {
    if (eta == 1) {
      return cosI;
    }
    // (η cosT)² by the form whose terms are smaller, and so are their rounding errors.
    double square = cosI < eta ? (eta - 1) * (eta + 1) + cosI * cosI : eta * eta - sin2I;
    return Elementary.safeSqrt(square) / eta;
  }
}
