package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;

/**
 * A weighted mean of two BSDFs: {@code share} of the first and the rest of the second.
 *
 * @param share in (0,1); also the probability of sampling the first
 */
record Blend(Bsdf first, Bsdf second, double share) implements Bsdf {
  /** The largest random number. */
  private static final double BELOW_ONE = 0x1.fffffffffffffp-1;

  @Override
  public Bsdf narrowed(Rgb throughput) {
    return new Blend(first.narrowed(throughput), second.narrowed(throughput), share);
  }

  @Override
  public boolean choosesLobe() {
    return true;
  }

  @Override
  public boolean isSpecular() {
    return first.isSpecular() && second.isSpecular();
  }

  @Override
  public boolean isTransmissive() {
    return first.isTransmissive() || second.isTransmissive();
  }

  @Override
  public boolean transmits() {
    return first.transmits() || second.transmits();
  }

  @Override
  public Rgb diffuseAlbedo() {
    return first.diffuseAlbedo().times(share).plus(second.diffuseAlbedo().times(1 - share));
  }

  @Override
  public void evaluate(
      double woX, double woY, double woZ, double wiX, double wiY, double wiZ, BsdfValue result) {
    first.evaluate(woX, woY, woZ, wiX, wiY, wiZ, result);
    Rgb f = result.f().times(share);
    double pdf = share * result.pdf();
    second.evaluate(woX, woY, woZ, wiX, wiY, wiZ, result);
    result.set(f.plus(result.f().times(1 - share)), pdf + (1 - share) * result.pdf());
  }

  @Override
  public void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    boolean drawsFirst = uLobe < share;
    // What is left of the random number is uniform again.
    double uRest = drawsFirst ? uLobe / share : Math.min(BELOW_ONE, (uLobe - share) / (1 - share));
    (drawsFirst ? first : second).sample(woX, woY, woZ, uRest, u, v, result);
    // A delta lobe's weight has the factor share, and its probability too.
    if (!result.isAbsorbed() && !result.isSpecular()) {
      result.weighBy(this, new Vec3(woX, woY, woZ));
    }
  }

  @Override
  public Rgb albedo() {
    return first.albedo().times(share).plus(second.albedo().times(1 - share));
  }

  @Override
  public Rgb clearAlbedo() {
    return first.clearAlbedo().times(share).plus(second.clearAlbedo().times(1 - share));
  }
}
