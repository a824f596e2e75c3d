package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.math.sampling.internal.Warp;

/**
 * Light that hits more than one facet, which single scattering loses: f = c · m(o) m(i) / π, where
 * m is the {@linkplain FacetLoss lost fraction} and c depends on the two sides (Kulla and Conty
 * 2017, "Revisiting Physically Based Shading at Imageworks", after Kelemen and Szirmay-Kalos 2001).
 * It is reciprocal, and with white single scattering it scatters all light.
 *
 * @param lost fraction by direction
 * @param above c of two directions above the surface
 * @param below c of two directions below the surface
 * @param down c of a viewer above and light below the surface
 * @param up c of a viewer below and light above the surface
 */
record MultipleScattering(FacetLoss lost, Rgb above, Rgb below, Rgb down, Rgb up) implements Lobe {
  /** The index of facets that reflect everything. */
  private static final double MIRRORS = Double.POSITIVE_INFINITY;

  /**
   * Returns the reflection by facets that absorb what they do not reflect: in n reflections, mean
   * reflectance F leaves F^n of the light (Kulla and Conty 2017; F = 1 loses nothing, and colors
   * become more saturated).
   *
   * @param fresnel mean reflectance of a facet under uniform radiance, each component in [0,1]
   * @param share fraction of the facets, in [0,1]
   * @param alpha roughness
   */
  static MultipleScattering reflected(Rgb fresnel, double share, double alpha) {
    FacetLoss lost = FacetLoss.of(MIRRORS, alpha);
    double mean = lost.mean(false);
    Rgb color =
        new Rgb(
            reflected(fresnel.r(), mean),
            reflected(fresnel.g(), mean),
            reflected(fresnel.b(), mean));
    Rgb c = color.times(share * inverse(mean));
    return new MultipleScattering(lost, c, c, Rgb.BLACK, Rgb.BLACK);
  }

  private static double reflected(double fresnel, double lost) {
    return fresnel * fresnel * (1 - lost) / (1 - fresnel * lost);
  }

  /**
   * Returns the scattering by a thin pane.
   *
   * @param tint of transmitted light, each component in [0,1]
   * @param fresnel mean reflectance of a facet under uniform radiance, each component in [0,1]
   */
  static MultipleScattering ofPane(Rgb tint, Rgb fresnel, double alpha) {
    FacetLoss lost = FacetLoss.of(MIRRORS, alpha);
    double scale = inverse(lost.mean(false));
    Rgb reflects = fresnel.times(scale);
    Rgb passes = ThinGlass.passed(tint, fresnel).times(scale);
    return new MultipleScattering(lost, reflects, reflects, passes, passes);
  }

  /**
   * Returns the scattering by rough glass. The fractions that pass are at most those of a smooth
   * surface under uniform radiance, and as large as reciprocity then allows: radiance over the
   * squared index is the same there and back.
   *
   * @param reflectance tints reflected light, each component in [0,1]
   * @param transmittance tints transmitted light, each component in [0,1]
   * @param ior index of refraction of the inside relative to the outside, &gt; 0
   */
  static MultipleScattering ofGlass(Rgb reflectance, Rgb transmittance, double ior, double alpha) {
    FacetLoss lost = FacetLoss.of(ior, alpha);
    double outer = lost.mean(false);
    double inner = lost.mean(true);
    double square = ior * ior;
    double up = leaving(ior) * inverse(Math.max(outer, inner));
    double down = square * up;
    return new MultipleScattering(
        lost,
        reflectance.times((1 - down * inner) * inverse(outer)),
        reflectance.times((1 - up * outer) * inverse(inner)),
        transmittance.times(down),
        transmittance.times(up));
  }

  private static double inverse(double x) {
    return x > 0 ? 1 / x : 0;
  }

  /**
   * Returns the mean reflectance of a dielectric under uniform radiance, as fitted by Kulla and
   * Conty 2017. The fit is wrong by at most 0.0065.
   *
   * @param ior index of refraction of the inside relative to the outside, from where the light
   *     comes, &gt; 0
   */
  static double meanReflectance(double ior) {
    return ior >= 1 ? (ior - 1) / (4.08567 + 1.00071 * ior) : 1 - ior * ior * leaving(ior);
  }

  /**
   * Returns the mean fraction that a dielectric lets out under uniform radiance inside. Radiance
   * over the squared index is the same there and back.
   */
  private static double leaving(double ior) {
    return ior >= 1
        ? (1 - meanReflectance(ior)) / (ior * ior)
        : 1 - (1 - ior) / (4.08567 * ior + 1.00071);
  }

  private Rgb factor(double woZ, double wiZ) {
    if (woZ > 0) {
      return wiZ > 0 ? above : down;
    }
    return wiZ > 0 ? up : below;
  }

  /** Returns the fraction of the light lost to a side that is scattered to a side. */
  private double share(Rgb factor, boolean isBelow) {
    return factor.max() * lost.mean(isBelow);
  }

  /** Returns the probability of sampling the viewer's own side; 1 if nothing is scattered. */
  private double shareOfOwnSide(double woZ) {
    boolean isBelow = woZ < 0;
    double own = share(factor(woZ, woZ), isBelow);
    double other = share(factor(woZ, -woZ), !isBelow);
    return other > 0 ? own / (own + other) : 1;
  }

  @Override
  public boolean choosesLobe() {
    return true;
  }

  @Override
  public boolean isTransmissive() {
    return !down.isBlack() || !up.isBlack();
  }

  @Override
  public void evaluate(
      double woX, double woY, double woZ, double wiX, double wiY, double wiZ, BsdfValue result) {
    if (woZ == 0 || wiZ == 0) {
      result.clear();
      return;
    }
    double own = shareOfOwnSide(woZ);
    Rgb factor = factor(woZ, wiZ);
    result.set(
        factor.times(lost.at(woZ) * lost.at(wiZ) * Warp.cosineHemispherePdf(Math.abs(wiZ))),
        lost.density(wiZ) * (woZ * wiZ > 0 ? own : 1 - own));
  }

  @Override
  public boolean draw(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    boolean isBelow = woZ < 0 == uLobe < shareOfOwnSide(woZ);
    double z = lost.drawnCosine(u, isBelow);
    double across = Elementary.safeSqrt((1 - z) * (1 + z));
    double x = across * Elementary.cosTurns(v);
    double y = across * Elementary.sinTurns(v);
    result.setDirection(new Vec3(x, y, isBelow ? -z : z).normalized());
    return z > 0 && woZ != 0;
  }

  @Override
  public double importance(double cosine) {
    boolean isBelow = cosine < 0;
    return lost.at(cosine)
        * (share(factor(cosine, cosine), isBelow) + share(factor(cosine, -cosine), !isBelow));
  }

  /** Returns black: at normal incidence, smooth facets determine the color. */
  @Override
  public Rgb albedo() {
    return Rgb.BLACK;
  }
}
