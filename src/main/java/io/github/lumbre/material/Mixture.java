package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;

/**
 * The sum of two lobes, which must not reflect more than 1 together: one is drawn, in proportion to
 * its importance, and both count for the direction it gives.
 */
record Mixture(Lobe first, Lobe second) implements Bsdf {
  @Override
  public Rgb eval(Vec3 wo, Vec3 wi) {
    return first.eval(wo, wi).plus(second.eval(wo, wi));
  }

  @Override
  public double pdf(Vec3 wo, Vec3 wi) {
    double share = shareOfFirst(wo);
    return share * first.pdf(wo, wi) + (1 - share) * second.pdf(wo, wi);
  }

  @Override
  public BsdfSample sample(Vec3 wo, double uLobe, Point2 u) {
    double share = shareOfFirst(wo);
    boolean drawsFirst = uLobe < share;
    Lobe drawn = drawsFirst ? first : second;
    BsdfSample sample = drawn.sample(wo, uLobe, u);
    if (!(sample.pdf() > 0)) {
      return BsdfSample.ABSORBED;
    }
    if (sample.isSpecular()) {
      return BsdfSample.specular(
          sample.wi(), sample.weight().times(1 / (drawsFirst ? share : 1 - share)));
    }
    double pdf = pdf(wo, sample.wi());
    if (!(pdf > 0)) {
      // So close to the horizon that the product of two cosines is 0.
      return BsdfSample.ABSORBED;
    }
    return new BsdfSample(sample.wi(), eval(wo, sample.wi()).times(1 / pdf), pdf);
  }

  private double shareOfFirst(Vec3 wo) {
    double one = first.importance(wo);
    double sum = one + second.importance(wo);
    return sum == 0 ? .5 : one / sum;
  }

  @Override
  public Rgb diffuseAlbedo() {
    return first.diffuseAlbedo().plus(second.diffuseAlbedo());
  }
}
