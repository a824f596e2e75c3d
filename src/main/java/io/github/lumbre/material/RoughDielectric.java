package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;

/**
 * A boundary of rough glass: each facet reflects by the exact Fresnel equations and refracts by
 * Snell's law (Walter et al. 2007). The inside is where z is negative. Light that hits more than
 * one facet is lost.
 *
 * @param reflectance tints what is reflected, each component in [0,1]
 * @param transmittance tints what passes, each component in [0,1]
 * @param ior index of refraction inside over the one outside, &gt; 0 and not 1: 1e-8 away from it,
 *     half the digits of a refracted direction are left
 */
public record RoughDielectric(
    Rgb reflectance, Rgb transmittance, double ior, MicrofacetDistribution facets) implements Bsdf {
  @Override
  public boolean isTransmissive() {
    return true;
  }

  /**
   * {@inheritDoc}
   *
   * <p>What both directions enter alike is computed alike whichever is wo, so that rounding leaves
   * scattering reciprocal: near the critical angle, and from nearly smooth surfaces, shares and
   * densities hang on the last digits of the facet.
   */
  @Override
  public void evaluate(
      double woX, double woY, double woZ, double wiX, double wiY, double wiZ, BsdfValue result) {
    Vec3 wo = new Vec3(woX, woY, woZ);
    Vec3 wi = new Vec3(wiX, wiY, wiZ);
    double sides = wo.z() * wi.z();
    if (sides > 0) {
      reflect(wo, wi, result);
    } else if (sides < 0) {
      refract(wo, wi, result);
    } else {
      result.clear();
    }
  }

  private void reflect(Vec3 wo, Vec3 wi, BsdfValue result) {
    Vec3 sum = wo.plus(wi);
    // Half the sum is as long as the cosine at the facet.
    double fresnel = Fresnel.dielectric(Math.min(1, .5 * sum.length()), eta(wo));
    double density =
        facets.density(outward(sum.normalized())) / (4 * facets.visible(Math.abs(wo.z())));
    set(result, reflectance, fresnel, density, fresnel, masking(wo, wi));
  }

  private void refract(Vec3 wo, Vec3 wi, BsdfValue result) {
    Vec3 outer = wo.z() > 0 ? wo : wi;
    Vec3 inner = wo.z() > 0 ? wi : wo;
    Vec3 sum = outer.plus(ior, inner);
    Vec3 m = outward(sum.normalized());
    double cosOuter = outer.dot(m);
    double cosInner = -inner.dot(m);
    if (!(cosOuter > 0 && cosInner > 0)) {
      result.clear();
      return;
    }
    // From the side on which there is no critical angle.
    double fresnel =
        ior > 1
            ? Fresnel.dielectric(Math.min(1, cosOuter), ior)
            : Fresnel.dielectric(Math.min(1, cosInner), 1 / ior);
    // Walter et al. 2007, eq. 17: the sum is as long as the difference of the scaled cosines.
    double spread = (wi.z() < 0 ? ior : 1) / sum.length();
    double density =
        facets.density(m)
            * (cosOuter * cosInner)
            * (spread * spread)
            / facets.visible(Math.abs(wo.z()));
    set(result, transmittance, 1 - fresnel, density, fresnel, masking(wo, wi));
  }

  private double masking(Vec3 wo, Vec3 wi) {
    return facets.maskingRatio(Math.abs(wo.z()), Math.abs(wi.z()));
  }

  /**
   * Sets what is scattered and its density.
   *
   * @param share of the light at the facet that takes this way, tint aside
   * @param density of wi per solid angle once the way is chosen
   */
  private void set(
      BsdfValue result, Rgb tint, double share, double density, double fresnel, double masking) {
    double all = scattered(fresnel);
    if (density > 0 && all > 0) {
      result.set(tint.times(share * masking * density), density * (share * tint.max() / all));
    } else {
      result.clear();
    }
  }

  /** Returns the largest share of the light at a facet that is reflected or refracted. */
  private double scattered(double fresnel) {
    return fresnel * reflectance.max() + (1 - fresnel) * transmittance.max();
  }

  private static Vec3 outward(Vec3 m) {
    return m.times(m.z() < 0 ? -1 : 1);
  }

  @Override
  public boolean choosesLobe() {
    return true;
  }

  @Override
  public void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    Vec3 wo = new Vec3(woX, woY, woZ);
    if (wo.z() == 0) {
      result.absorb();
      return;
    }
    Vec3 o = up(wo, wo);
    Vec3 m = facets.sampleVisible(o, new Point2(u, v));
    double cosO = Math.min(1, o.dot(m));
    double eta = eta(wo);
    double fresnel = Fresnel.dielectric(cosO, eta);
    double all = scattered(fresnel);
    boolean reflects = uLobe * all < fresnel * reflectance.max();
    Vec3 i =
        reflects
            ? m.times(2 * cosO).minus(o).normalized()
            : m.times(cosO / eta - Fresnel.cosTransmitted(cosO, (1 - cosO) * (1 + cosO), eta))
                .plus(-1 / eta, o)
                .normalized();
    if (reflects ? !(i.z() > 0) : !(i.z() < 0)) {
      result.absorb();
      return;
    }
    result.setDirection(up(i, wo));
    result.weighBy(this, wo);
  }

  private double eta(Vec3 wo) {
    return wo.z() > 0 ? ior : 1 / ior;
  }

  /** Returns w with the surface turned so that wo is above it; the same call turns back. */
  private static Vec3 up(Vec3 w, Vec3 wo) {
    return new Vec3(w.x(), w.y(), wo.z() > 0 ? w.z() : -w.z());
  }
}
