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
   * @param eta index of refraction behind the boundary over the one before it, &gt; 0
   */
  public static double dielectric(double cosI, double eta) {
    double sin2T = (1 - cosI * cosI) / (eta * eta);
    if (sin2T >= 1) {
      return 1;
    }
    double cosT = Math.sqrt(1 - sin2T);
    if (eta == 1) {
      return 0;
    }
    double parallel = (eta * cosI - cosT) / (eta * cosI + cosT);
    double perpendicular = (cosI - eta * cosT) / (cosI + eta * cosT);
    return Math.min(1, .5 * (parallel * parallel + perpendicular * perpendicular));
  }

  /** Returns the cosine of the refracted angle, or 0 where there is only reflection. */
  static double cosTransmitted(double cosI, double eta) {
    return eta == 1 ? cosI : Elementary.safeSqrt(1 - (1 - cosI * cosI) / (eta * eta));
  }
}
