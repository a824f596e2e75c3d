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

  /** Returns Smith's Λ: hidden over visible area, seen under an angle. */
  double lambda(double cosTheta);

  /** Draws a normal in proportion to its visible area: with density {@link #visibleDensity}. */
  Vec3 sampleVisible(Vec3 wo, Point2 u);

  /** Returns G1 · max(0, wo·m) · D / cos θo, per solid angle. */
  default double visibleDensity(Vec3 wo, Vec3 m) {
    return Math.max(0, wo.dot(m)) * density(m) / (wo.z() * (1 + lambda(wo.z())));
  }

  /** Returns the share of facets seen from one direction that is also seen from the other. */
  default double maskingRatio(double cosO, double cosI) {
    double lambdaO = lambda(cosO);
    return (1 + lambdaO) / (1 + lambdaO + lambda(cosI));
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
