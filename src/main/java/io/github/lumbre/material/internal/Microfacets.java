package io.github.lumbre.material.internal;

import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.MicrofacetDistribution;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;

/**
 * The distribution of the microfacet normals of a rough surface, with its masking and shadowing
 * (PBRT 4e, sec. 9.6). All directions are unit vectors in the local frame, above the surface.
 * Immutable.
 */
public sealed interface Microfacets permits Beckmann, Ggx {
  /**
   * The largest roughness α of a mirror or of clear glass: what is seen in it is blurred by about
   * half a degree.
   */
  double CLEAR = .004;

  /** Returns the roughness α &gt; 0. */
  double alpha();

  /** Returns whether other surfaces are recognized in what the facets reflect or refract. */
  default boolean areClear() {
    return alpha() <= CLEAR;
  }

  /**
   * Returns the density D of normals at m, per solid angle and per projected area of the surface.
   */
  double density(Vec3 m);

  /**
   * Returns Λ(θ) · cos θ, where Λ is Smith's ratio of hidden to visible microfacet area. Unlike Λ,
   * the product stays finite towards the horizon.
   *
   * @param cosTheta cosine of the angle θ to the normal, in [0,1]
   */
  double hidden(double cosTheta);

  /** Returns (1 + Λ(θ)) · cos θ; the argument is in [0,1]. */
  default double visible(double cosTheta) {
    return cosTheta + hidden(cosTheta);
  }

  /**
   * Samples a microfacet normal m in proportion to the area visible from wo: with the density per
   * solid angle G1 · max(0, wo·m) · D / cos θo, with G1 = 1 / (1 + Λ).
   *
   * @param u uniform in [0,1)²
   */
  Vec3 sampleVisible(Vec3 wo, Point2 u);

  /**
   * Samples the direction that a visible facet reflects, on both sides of the surface, and sets it.
   * Returns whether it is on the viewer's side.
   *
   * @param u uniform in [0,1), as is v
   */
  default boolean draw(double woX, double woY, double woZ, double u, double v, BsdfSample result) {
    double side = woZ > 0 ? 1 : -1;
    Vec3 o = new Vec3(woX, woY, woZ).times(side);
    Vec3 m = sampleVisible(o, new Point2(u, v));
    Vec3 i = m.times(2 * o.dot(m)).minus(o).normalized();
    result.setDirection(i.times(side));
    return woZ != 0 && i.z() > 0;
  }

  /**
   * Returns the fraction, in [0,1], of the microfacets visible from one direction that are also
   * visible from the other. With height-correlated masking it is G / G1 = (1 + Λo) / (1 + Λo + Λi).
   *
   * @param cosO cosine of the first direction's angle to the normal, in (0,1]
   * @param cosI cosine of the second direction's angle to the normal, in (0,1]
   */
  default double maskingRatio(double cosO, double cosI) {
    return maskingRatio(cosO, visible(cosO), cosI);
  }

  /**
   * Returns the same ratio.
   *
   * @param visibleO result of {@link #visible} for the first direction
   */
  default double maskingRatio(double cosO, double visibleO, double cosI) {
    return 1 / (1 + hidden(cosI) / cosI * (cosO / visibleO));
  }

  /** Returns the distribution of a kind for a roughness α &gt; 0. */
  static Microfacets of(MicrofacetDistribution kind, double alpha) {
    return kind == MicrofacetDistribution.BECKMANN ? new Beckmann(alpha) : new Ggx(alpha);
  }
}
