package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
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
  public void evaluate(BsdfValue value) {
    Vec3 wo = value.wo();
    Vec3 wi = value.wi();
    if (!(wo.z() * wi.z() > 0)) {
      value.clear();
      return;
    }
    Vec3 o = up(wo);
    Vec3 i = up(wi);
    Vec3 sum = o.plus(i);
    // Half the sum is as long as the cosine at the facet; a dot product would lose digits.
    double fresnel = Fresnel.dielectric(Math.min(1, .5 * sum.length()), ior);
    // Mirrors spread the density of visible normals by 4 times that cosine, which cancels.
    double visible = facets.visible(o.z());
    double pdf = facets.density(sum.normalized()) / (4 * visible);
    value.set(specular.times(fresnel * facets.maskingRatio(o.z(), visible, i.z()) * pdf), pdf);
  }

  @Override
  public boolean draw(BsdfSample drawn) {
    Vec3 wo = drawn.wo();
    Vec3 o = up(wo);
    Vec3 m = facets.sampleVisible(o, drawn.random());
    Vec3 i = m.times(2 * o.dot(m)).minus(o).normalized();
    drawn.setDirection(i.times(side(wo)));
    return wo.z() != 0 && i.z() > 0;
  }

  @Override
  public void sample(BsdfSample drawn) {
    if (draw(drawn)) {
      drawn.weighBy(this);
    } else {
      drawn.absorb();
    }
  }

  @Override
  public double importance(double cosine) {
    return specular.max() * Fresnel.dielectric(Math.abs(cosine), ior);
  }

  /** Returns 1 of directions above the surface, else -1. */
  private static double side(Vec3 w) {
    return w.z() > 0 ? 1 : -1;
  }

  /** Returns the direction turned to the upper side; from behind, the surface is turned over. */
  private static Vec3 up(Vec3 w) {
    return w.times(side(w));
  }
}
