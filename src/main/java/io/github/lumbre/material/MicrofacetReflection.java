package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;

/**
 * Reflection by the small mirrors of a rough surface, each by the exact Fresnel equations: f = F D
 * G / (4 cos θo cos θi), with height-correlated masking (Cook &amp; Torrance 1982; PBRT 4e, sec.
 * 9.6), on both sides of the surface. Light that meets more than one facet is lost.
 *
 * @param specular tints the reflection, each component in [0,1]
 * @param ior index of refraction of the facets, &gt; 0
 */
record MicrofacetReflection(Rgb specular, double ior, MicrofacetDistribution facets)
    implements Lobe {
  @Override
  public Rgb eval(Vec3 wo, Vec3 wi) {
    if (!(wo.z() * wi.z() > 0)) {
      return Rgb.BLACK;
    }
    Vec3 o = up(wo);
    Vec3 i = up(wi);
    Vec3 sum = o.plus(i);
    // Half the sum is as long as the cosine at the facet; a dot product would lose digits.
    double fresnel = Fresnel.dielectric(Math.min(1, .5 * sum.length()), ior);
    double masking = facets.maskingRatio(o.z(), i.z());
    return specular.times(fresnel * masking * drawn(o, sum.normalized()));
  }

  @Override
  public double pdf(Vec3 wo, Vec3 wi) {
    if (!(wo.z() * wi.z() > 0)) {
      return 0;
    }
    Vec3 o = up(wo);
    return drawn(o, o.plus(up(wi)).normalized());
  }

  /** Returns the density of the direction that a visible normal mirrors o into. */
  private double drawn(Vec3 o, Vec3 m) {
    double cos = o.dot(m);
    return cos > 0 ? facets.visibleDensity(o, m) / (4 * cos) : 0;
  }

  @Override
  public BsdfSample sample(Vec3 wo, double uLobe, Point2 u) {
    if (wo.z() == 0) {
      return BsdfSample.ABSORBED;
    }
    Vec3 o = up(wo);
    Vec3 m = facets.sampleVisible(o, u);
    Vec3 i = m.times(2 * o.dot(m)).minus(o).normalized();
    double pdf = i.z() > 0 ? drawn(o, o.plus(i).normalized()) : 0;
    if (!(pdf > 0) || pdf == Double.POSITIVE_INFINITY) {
      return BsdfSample.ABSORBED;
    }
    double fresnel = Fresnel.dielectric(Math.min(1, o.dot(m)), ior);
    return new BsdfSample(
        wo.z() > 0 ? i : i.negated(),
        specular.times(fresnel * facets.maskingRatio(o.z(), i.z())),
        pdf);
  }

  @Override
  public double importance(Vec3 wo) {
    return specular.max() * Fresnel.dielectric(Math.abs(wo.z()), ior);
  }

  /** Returns the direction turned to the upper side; from behind, the surface is turned over. */
  private static Vec3 up(Vec3 w) {
    return w.z() > 0 ? w : w.negated();
  }
}
