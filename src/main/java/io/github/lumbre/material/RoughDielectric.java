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
 * @param ior index of refraction inside over the one outside, &gt; 0 and not 1
 */
public record RoughDielectric(
    Rgb reflectance, Rgb transmittance, double ior, MicrofacetDistribution facets) implements Bsdf {
  @Override
  public Rgb eval(Vec3 wo, Vec3 wi) {
    Vec3 m = facetBetween(wo, wi);
    double density = density(wo, wi, m);
    if (!(density > 0)) {
      return Rgb.BLACK;
    }
    boolean reflects = wo.z() * wi.z() > 0;
    double fresnel = Fresnel.dielectric(Math.min(1, up(wo, wo).dot(m)), eta(wo));
    double masking = facets.maskingRatio(Math.abs(wo.z()), Math.abs(wi.z()));
    return reflects
        ? reflectance.times(fresnel * masking * density)
        : transmittance.times((1 - fresnel) * masking * density);
  }

  @Override
  public double pdf(Vec3 wo, Vec3 wi) {
    Vec3 m = facetBetween(wo, wi);
    double density = density(wo, wi, m);
    if (!(density > 0)) {
      return 0;
    }
    double reflect = reflectProbability(Math.min(1, up(wo, wo).dot(m)), eta(wo));
    return density * (wo.z() * wi.z() > 0 ? reflect : 1 - reflect);
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
  public BsdfSample sample(Vec3 wo, double uLobe, Point2 u) {
    if (wo.z() == 0) {
      return BsdfSample.ABSORBED;
    }
    Vec3 o = up(wo, wo);
    Vec3 m = facets.sampleVisible(o, u);
    double cosO = Math.min(1, o.dot(m));
    double eta = eta(wo);
    double reflect = reflectProbability(cosO, eta);
    boolean reflects = uLobe < reflect;
    Vec3 i =
        reflects
            ? m.times(2 * cosO).minus(o).normalized()
            : m.times(cosO / eta - Fresnel.cosTransmitted(cosO, (1 - cosO) * (1 + cosO), eta))
                .plus(-1 / eta, o)
                .normalized();
    if (reflects ? !(i.z() > 0) : !(i.z() < 0)) {
      return BsdfSample.ABSORBED;
    }
    Vec3 wi = up(i, wo);
    double pdf = pdf(wo, wi);
    if (!(pdf > 0) || pdf == Double.POSITIVE_INFINITY) {
      return BsdfSample.ABSORBED;
    }
    double fresnel = Fresnel.dielectric(cosO, eta);
    double masking = facets.maskingRatio(o.z(), Math.abs(i.z()));
    Rgb weight =
        reflects
            ? reflectance.times(masking * fresnel / reflect)
            : transmittance.times(masking * (1 - fresnel) / (1 - reflect));
    return new BsdfSample(wi, weight, pdf);
  }

  private double reflectProbability(double cosO, double eta) {
    double fresnel = Fresnel.dielectric(cosO, eta);
    double reflect = fresnel * reflectance.max();
    double sum = reflect + (1 - fresnel) * transmittance.max();
    return sum == 0 ? .5 : reflect / sum;
  }

  private double eta(Vec3 wo) {
    return wo.z() > 0 ? ior : 1 / ior;
  }

  /** Returns w with the surface turned so that wo is above it; the same call turns back. */
  private static Vec3 up(Vec3 w, Vec3 wo) {
    return wo.z() > 0 ? w : new Vec3(w.x(), w.y(), -w.z());
  }
}
