package io.github.lumbre.material;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;

/**
 * How the small mirrors of a rough surface are turned, and how they hide each other (PBRT 4e, sec.
 * 9.6). All directions are local, of unit length and above the surface. Immutable.
 */
public sealed interface MicrofacetDistribution permits Beckmann, Ggx {
  /** Returns the density D of normals, per solid angle and projected area. */
  double density(Vec3 m);

  /**
   * Returns Λ(θ) · cos θ, Λ being Smith's ratio of hidden to visible area: unlike Λ itself, it
   * stays finite towards the horizon.
   *
   * @param cosTheta in [0,1]
   */
  double hidden(double cosTheta);

  /** Returns (1 + Λ(θ)) · cos θ. */
  default double visible(double cosTheta) {
    return cosTheta + hidden(cosTheta);
  }

  /** Draws a normal in proportion to its visible area: with density {@link #visibleDensity}. */
  Vec3 sampleVisible(Vec3 wo, Point2 u);

  /** Returns G1 · max(0, wo·m) · D / cos θo, per solid angle, with G1 = 1 / (1 + Λ). */
  default double visibleDensity(Vec3 wo, Vec3 m) {
    return Math.max(0, wo.dot(m)) * density(m) / visible(wo.z());
  }

  /**
   * Returns the share of facets seen from one direction that is also seen from the other: G / G1 =
   * (1 + Λo) / (1 + Λo + Λi), if height decides about both.
   *
   * @param cosO in (0,1]
   * @param cosI in (0,1]
   */
  default double maskingRatio(double cosO, double cosI) {
    return maskingRatio(cosO, visible(cosO), cosI);
  }

  /** Returns the same, given what {@link #visible} returns for the first direction. */
  default double maskingRatio(double cosO, double visibleO, double cosI) {
    return 1 / (1 + hidden(cosI) / cosI * (cosO / visibleO));
  }

  /** Returns the distribution that a roughness α gives. */
  static MicrofacetDistribution of(Kind kind, double alpha) {
    return kind == Kind.BECKMANN ? new Beckmann(alpha) : new Ggx(alpha);
  }

  /** Which distribution. */
  enum Kind {
    BECKMANN,
    GGX
  }
}
