package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;

/**
 * The sum of two lobes, which together must not reflect more than all light. One lobe is selected
 * in proportion to its importance and sampled; the weight and density of the direction include both
 * lobes.
 */
record Mixture(Lobe first, Lobe second) implements Bsdf {
  /** The largest random number. */
  private static final double BELOW_ONE = 0x1.fffffffffffffp-1;

  @Override
  public double pdf(Vec3 wo, Vec3 wi) {
    double share = shareOfFirst(wo.z());
    return share * first.pdf(wo, wi) + (1 - share) * second.pdf(wo, wi);
  }

  @Override
  public void evaluate(
      double woX, double woY, double woZ, double wiX, double wiY, double wiZ, BsdfValue result) {
    double share = shareOfFirst(woZ);
    first.evaluate(woX, woY, woZ, wiX, wiY, wiZ, result);
    Rgb f = result.f();
    double pdf = share * result.pdf();
    second.evaluate(woX, woY, woZ, wiX, wiY, wiZ, result);
    result.set(f.plus(result.f()), pdf + (1 - share) * result.pdf());
  }

  @Override
  public boolean choosesLobe() {
    return true;
  }

  @Override
  public void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    double share = shareOfFirst(woZ);
    boolean drawsFirst = uLobe < share;
    Lobe chosen = drawsFirst ? first : second;
    // What is left of the random number is uniform again.
    double uRest = drawsFirst ? uLobe / share : Math.min(BELOW_ONE, (uLobe - share) / (1 - share));
    if (!chosen.draw(woX, woY, woZ, uRest, u, v, result)) {
      result.absorb();
    } else if (chosen.isSpecular()) {
      result.setSpecular(result.wi(), result.weight().times(1 / (drawsFirst ? share : 1 - share)));
    } else {
      // The weight includes both lobes, whichever of them sampled the direction.
      result.weighBy(this, new Vec3(woX, woY, woZ));
    }
  }

  private double shareOfFirst(double cosine) {
    double one = first.importance(cosine);
    double sum = one + second.importance(cosine);
    return sum == 0 ? .5 : one / sum;
  }

  @Override
  public boolean isTransmissive() {
    return first.isTransmissive() || second.isTransmissive();
  }

  @Override
  public Rgb diffuseAlbedo() {
    return first.diffuseAlbedo().plus(second.diffuseAlbedo());
  }

  @Override
  public Rgb albedo() {
    return first.albedo().plus(second.albedo()).clampedToOne();
  }

  @Override
  public Rgb clearAlbedo() {
    return first.clearAlbedo().plus(second.clearAlbedo()).clampedToOne();
  }
}
