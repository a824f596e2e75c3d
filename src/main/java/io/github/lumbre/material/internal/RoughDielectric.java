package io.github.lumbre.material.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Bsdf;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;

/**
 * The BSDF of rough glass: each microfacet reflects by the exact Fresnel equations and refracts by
 * Snell's law (Walter et al. 2007). The inside of the glass is at negative z. Light that hits more
 * than one microfacet is lost.
 *
 * @param reflectance tints the reflected light, each component in [0,1]
 * @param transmittance tints the refracted light, each component in [0,1]
 * @param ior index of refraction of the inside relative to the outside, &gt; 0 and not 1. At a
 *     distance of 1e-8 from 1, a refracted direction has only half of its digits left
 * @param facets distribution of the microfacet normals
 * @param film above the facets; the index must be at least 1 if there is one
 * @param color of the light in the film: 0 to 2 for red, green and blue
 */
public record RoughDielectric(
    Rgb reflectance, Rgb transmittance, double ior, Microfacets facets, ThinFilm film, int color)
    implements Bsdf {
  /** Creates rough glass without a film. */
  public RoughDielectric(Rgb reflectance, Rgb transmittance, double ior, Microfacets facets) {
    this(reflectance, transmittance, ior, facets, ThinFilm.NONE, 0);
  }

  @Override
  public boolean isBareGlass() {
    return true;
  }

  @Override
  public boolean isTransmissive() {
    return true;
  }

  /**
   * {@inheritDoc}
   *
   * <p>Terms that are symmetric in wo and wi are computed identically after the two are swapped, so
   * that scattering stays reciprocal despite rounding. This matters near the critical angle and for
   * nearly smooth surfaces, where reflectances and densities depend on the last digits of the
   * microfacet normal.
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
    // Half the sum's length is the cosine at the facet.
    double fresnel = reflected(Math.min(1, .5 * sum.length()), wo.z() > 0);
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
    // Evaluate on the side that has no critical angle.
    double fresnel =
        ior > 1 ? reflected(Math.min(1, cosOuter), true) : reflected(Math.min(1, cosInner), false);
    // Walter et al. 2007, eq. 17. The sum's length is the difference of the scaled cosines.
    double spread = (wi.z() < 0 ? ior : 1) / sum.length();
    double density =
        facets.density(m)
            * (cosOuter * cosInner)
            * (spread * spread)
            / facets.visible(Math.abs(wo.z()));
    set(result, transmittance, 1 - fresnel, density, fresnel, masking(wo, wi));
  }

  /**
   * Returns the fraction of light that a facet reflects.
   *
   * @param cosine of the angle at the facet, in [0,1]
   * @param isOutside whether the light comes from the outside
   */
  private double reflected(double cosine, boolean isOutside) {
    return film.over(color, cosine, isOutside, ior);
  }

  private double masking(Vec3 wo, Vec3 wi) {
    return facets.maskingRatio(Math.abs(wo.z()), Math.abs(wi.z()));
  }

  /**
   * Sets the value and the density of one kind of scattering, reflection or refraction.
   *
   * @param share fraction of the light at the facet that is scattered this way, without the tint
   * @param density density of wi per solid angle, given this kind of scattering
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

  /**
   * Returns the largest component of the fraction of light at a facet that is reflected or
   * refracted.
   */
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
    double fresnel = reflected(cosO, wo.z() > 0);
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

  /** Returns w for a surface flipped so that wo lies above it. The same call undoes the flip. */
  private static Vec3 up(Vec3 w, Vec3 wo) {
    return new Vec3(w.x(), w.y(), wo.z() > 0 ? w.z() : -w.z());
  }

  @Override
  public Rgb albedo() {
    return transmittance;
  }

  @Override
  public Rgb clearAlbedo() {
    return facets.areClear() ? albedo() : Rgb.BLACK;
  }
}
