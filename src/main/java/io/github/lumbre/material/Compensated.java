package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Ggx;
import io.github.lumbre.material.internal.RoughDielectric;
import io.github.lumbre.math.Vec3;

/**
 * Single scattering by rough facets together with the light that hits more than one facet.
 *
 * @param single without delta lobes
 */
record Compensated(Bsdf single, MultipleScattering rest) implements Lobe {
  /** The largest random number. */
  private static final double BELOW_ONE = 0x1.fffffffffffffp-1;

  /** Returns rough glass; see {@link MultipleScattering#ofGlass}. */
  static Compensated glass(Rgb reflectance, Rgb transmittance, double ior, double alpha) {
    return new Compensated(
        new RoughDielectric(reflectance, transmittance, ior, new Ggx(alpha)),
        MultipleScattering.ofGlass(reflectance, transmittance, ior, alpha));
  }

  /** Returns a thin rough pane; see {@link MultipleScattering#ofPane}. */
  static Compensated pane(ThinGlass pane) {
    Rgb mean = SchlickReflection.meanFresnel(pane.f0(), pane.f90(), pane.film());
    return new Compensated(
        pane, MultipleScattering.ofPane(pane.tint(), mean, pane.facets().alpha()));
  }

  /** Returns the probability of sampling the rest. */
  private double share(double woZ) {
    return Math.min(.9, rest.importance(woZ));
  }

  @Override
  public boolean choosesLobe() {
    return true;
  }

  @Override
  public boolean isBareGlass() {
    return single.isBareGlass();
  }

  @Override
  public boolean isTransmissive() {
    return single.isTransmissive();
  }

  @Override
  public void evaluate(
      double woX, double woY, double woZ, double wiX, double wiY, double wiZ, BsdfValue result) {
    double share = share(woZ);
    single.evaluate(woX, woY, woZ, wiX, wiY, wiZ, result);
    Rgb f = result.f();
    double pdf = (1 - share) * result.pdf();
    rest.evaluate(woX, woY, woZ, wiX, wiY, wiZ, result);
    result.set(f.plus(result.f()), pdf + share * result.pdf());
  }

  @Override
  public void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    double share = share(woZ);
    if (draws(share, woX, woY, woZ, uLobe, u, v, result)) {
      result.weighBy(this, new Vec3(woX, woY, woZ));
    } else {
      result.absorb();
    }
  }

  private boolean draws(
      double share,
      double woX,
      double woY,
      double woZ,
      double uLobe,
      double u,
      double v,
      BsdfSample result) {
    // What is left of the random number is uniform again.
    if (uLobe < share) {
      return rest.draw(woX, woY, woZ, uLobe / share, u, v, result);
    }
    double uRest = Math.min(BELOW_ONE, (uLobe - share) / (1 - share));
    single.sample(woX, woY, woZ, uRest, u, v, result);
    return result.pdf() > 0;
  }

  @Override
  public double importance(double cosine) {
    double one = single instanceof Lobe lobe ? lobe.importance(cosine) : 1;
    return one + rest.importance(cosine);
  }

  @Override
  public Rgb albedo() {
    return single.albedo();
  }

  @Override
  public Rgb clearAlbedo() {
    return single.clearAlbedo();
  }
}
