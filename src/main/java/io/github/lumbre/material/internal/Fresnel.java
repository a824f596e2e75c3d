package io.github.lumbre.material.internal;

import io.github.lumbre.math.internal.Elementary;

/** The Fresnel reflectance of a smooth boundary between two dielectrics. */
public final class Fresnel {
  private Fresnel() {}

  /**
   * Returns the exact reflectance in [0,1] for unpolarized light (PBRT 4e, eq. 9.6): 0 if eta is 1,
   * and 1 beyond the critical angle.
   *
   * @param cosI cosine of the angle of incidence, in [0,1]
   * @param eta index of refraction of the transmitted side relative to the incident side, in
   *     [1e-150, 1e150]
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
   * @param squares a² − b²; used instead of a − b where that difference cancels, which happens if η
   *     is near 1
   */
  private static double ratio(double a, double b, double squares) {
    double difference = a - b;
    double sum = a + b;
    return Math.abs(difference) > .1 * sum ? difference / sum : squares / (sum * sum);
  }

  /**
   * Returns the cosine of the angle of refraction, or 0 at total internal reflection.
   *
   * @param sin2I squared sine of the angle of incidence
   */
  public static double cosTransmitted(double cosI, double sin2I, double eta) {
    if (eta == 1) {
      return cosI;
    }
    // (η cosT)², computed by the form with the smaller terms and hence the smaller rounding errors.
    double square = cosI < eta ? (eta - 1) * (eta + 1) + cosI * cosI : eta * eta - sin2I;
    return Elementary.safeSqrt(square) / eta;
  }
}
