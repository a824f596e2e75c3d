package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;

/**
 * A boundary of ground glass: each facet reflects by the exact Fresnel equations and refracts by
 * Snell's law (Walter et al. 2007). The inside is where z is negative. Light that meets more than
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

  @Override
  public Rgb eval(Vec3 wo, Vec3 wi) {
    Vec3 m = facetBetween(wo, wi);
    double density = density(wo, wi, m);
    if (!(density > 0)) {
      return Rgb.BLACK;
    }
    double fresnel = fresnel(wo, wi, m);
    double drawn = density * facets.maskingRatio(Math.abs(wo.z()), Math.abs(wi.z()));
    return wo.z() * wi.z() > 0
        ? reflectance.times(fresnel * drawn)
        : transmittance.times((1 - fresnel) * drawn);
  }

  @Override
  public double pdf(Vec3 wo, Vec3 wi) {
    Vec3 m = facetBetween(wo, wi);
    double density = density(wo, wi, m);
    if (!(density > 0)) {
      return 0;
    }
    double fresnel = fresnel(wo, wi, m);
    double all = scattered(fresnel);
    double part =
        wo.z() * wi.z() > 0 ? fresnel * reflectance.max() : (1 - fresnel) * transmittance.max();
    return all > 0 ? density * part / all : 0;
  }

  /** Returns how much of the light that meets a facet goes on, at most, either way. */
  private double scattered(double fresnel) {
    return fresnel * reflectance.max() + (1 - fresnel) * transmittance.max();
  }

  /** Returns the share that the facet between two directions reflects. */
  private double fresnel(Vec3 wo, Vec3 wi, Vec3 m) {
    double eta = eta(wo);
    double cosI = up(wi, wo).dot(m);
    // On the dense side, close to the critical angle, the share hangs on the last digits.
    return cosI < 0 && eta < 1
        ? Fresnel.dielectric(Math.min(1, -cosI), 1 / eta)
        : Fresnel.dielectric(Math.min(1, up(wo, wo).dot(m)), eta);
  }

  /** Returns the normal, on the side of wo, that takes wo to wi by a mirror or by Snell's law. */
  private Vec3 facetBetween(Vec3 wo, Vec3 wi) {
    Vec3 o = up(wo, wo);
    Vec3 i = up(wi, wo);
    Vec3 m = i.z() > 0 ? o.plus(i) : o.plus(eta(wo), i);
    Vec3 unit = m.normalized();
    return unit.z() < 0 ? unit.negated() : unit;
  }

  /** Returns the density of wi per solid angle once the kind of event is chosen. */
  private double density(Vec3 wo, Vec3 wi, Vec3 m) {
    Vec3 o = up(wo, wo);
    Vec3 i = up(wi, wo);
    double cosO = o.dot(m);
    double cosI = i.dot(m);
    if (o.z() == 0 || i.z() == 0 || !(cosO > 0) || !(cosI * i.z() > 0)) {
      return 0;
    }
    double visible = facets.visibleDensity(o, m);
    if (i.z() > 0) {
      return visible / (4 * cosO);
    }
    double eta = eta(wo);
    double sum = cosO + eta * cosI;
    return visible * eta * eta * -cosI / (sum * sum);
  }

  @Override
  public boolean choosesLobe() {
    return true;
  }

  @Override
  public void sample(Vec3 wo, double uLobe, Point2 u, BsdfSample drawn) {
    if (wo.z() == 0) {
      drawn.absorb();
      return;
    }
    Vec3 o = up(wo, wo);
    Vec3 m = facets.sampleVisible(o, u);
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
      drawn.absorb();
      return;
    }
    Vec3 wi = up(i, wo);
    double pdf = pdf(wo, wi);
    if (!(pdf > 0) || pdf == Double.POSITIVE_INFINITY) {
      drawn.absorb();
      return;
    }
    // Divided by the probability of its kind of event, the share is the larger part of all.
    Rgb tint =
        reflects
            ? reflectance.times(1 / reflectance.max())
            : transmittance.times(1 / transmittance.max());
    double masking = facets.maskingRatio(o.z(), Math.abs(i.z()));
    drawn.set(wi, tint.times(masking * all), pdf);
  }

  private double eta(Vec3 wo) {
    return wo.z() > 0 ? ior : 1 / ior;
  }

  /** Returns w with the surface turned so that wo is above it; the same call turns back. */
  private static Vec3 up(Vec3 w, Vec3 wo) {
    return wo.z() > 0 ? w : new Vec3(w.x(), w.y(), -w.z());
  }
}
