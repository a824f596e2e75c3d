package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Microfacets;
import io.github.lumbre.material.internal.SpecularReflection;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;

/**
 * The normalized modified Phong lobe, on both sides of the surface: f = specular · (n+2)/2π ·
 * cosⁿα, where α is the angle between wi and the mirror direction (Lafortune &amp; Willems 1994,
 * eq. 4). Its albedo is the specular color at normal incidence and smaller elsewhere: about cos θ
 * times that color if n is large.
 *
 * @param specular each component in [0,1]
 * @param exponent n, at least 0
 */
record PhongLobe(Rgb specular, double exponent) implements Lobe {
  /** The exponent of a lobe that is as narrow as that of {@linkplain Microfacets clear facets}. */
  private static final double CLEAR = 2 / (Microfacets.CLEAR * Microfacets.CLEAR);

  @Override
  public double pdf(Vec3 wo, Vec3 wi) {
    return wo.z() * wi.z() > 0 ? density(cosinePower(wo, wi)) : 0;
  }

  @Override
  public void evaluate(
      double woX, double woY, double woZ, double wiX, double wiY, double wiZ, BsdfValue result) {
    Vec3 wo = new Vec3(woX, woY, woZ);
    Vec3 wi = new Vec3(wiX, wiY, wiZ);
    if (wo.z() * wi.z() > 0) {
      double power = cosinePower(wo, wi);
      double f = (exponent + 2) / Elementary.TWO_PI * power * Math.abs(wi.z());
      result.set(specular.r() * f, specular.g() * f, specular.b() * f, density(power));
    } else {
      result.clear();
    }
  }

  private double density(double cosinePower) {
    return (exponent + 1) / Elementary.TWO_PI * cosinePower;
  }

  /**
   * Returns cosⁿα, computed from the distance between wi and the mirror direction, which stays
   * accurate at small α.
   */
  private double cosinePower(Vec3 wo, Vec3 wi) {
    double oneMinusCos = .5 * wi.minus(SpecularReflection.reflect(wo)).lengthSquared();
    return oneMinusCos < 1 ? Elementary.exp(exponent * Elementary.log1p(-oneMinusCos)) : 0;
  }

  @Override
  public void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    Vec3 wo = new Vec3(woX, woY, woZ);
    // cos α = (1−u)^(1/(n+1)); the sine is computed without cancellation.
    double logCos = Elementary.log1p(-u) / (exponent + 1);
    double cos = Elementary.exp(logCos);
    double sin = Math.sqrt(-Elementary.expm1(2 * logCos));
    Vec3 around = new Vec3(sin * Elementary.cosTurns(v), sin * Elementary.sinTurns(v), cos);
    Vec3 axis = SpecularReflection.reflect(wo);
    Vec3 across = Frame.tangentAround(axis);
    Vec3 wi = Frame.toWorld(across, Frame.bitangentAround(axis), axis, around).normalized();
    double pdf = pdf(wo, wi);
    if (!(pdf > 0)) {
      result.absorb();
      return;
    }
    double weight = (exponent + 2) / (exponent + 1) * Math.abs(wi.z());
    result.set(wi, specular.times(weight), pdf);
  }

  @Override
  public double importance(double cosine) {
    return specular.max();
  }

  @Override
  public Rgb albedo() {
    return specular;
  }

  @Override
  public Rgb clearAlbedo() {
    return exponent >= CLEAR ? albedo() : Rgb.BLACK;
  }
}
