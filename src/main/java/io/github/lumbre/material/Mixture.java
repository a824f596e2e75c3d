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
  public void evaluate(Vec3 wo, Vec3 wi, BsdfValue value) {
    double share = shareOfFirst(wo);
    first.evaluate(wo, wi, value);
    Rgb f = value.f();
    double pdf = share * value.pdf();
    second.evaluate(wo, wi, value);
    value.set(f.plus(value.f()), pdf + (1 - share) * value.pdf());
  }

  @Override
  public boolean choosesLobe() {
    return true;
  }

  @Override
  public void sample(Vec3 wo, double uLobe, Point2 u, BsdfSample drawn) {
    double share = shareOfFirst(wo);
    boolean drawsFirst = uLobe < share;
    Lobe chosen = drawsFirst ? first : second;
    if (!chosen.draw(wo, u, drawn)) {
      drawn.absorb();
    } else if (chosen.isSpecular()) {
      drawn.setSpecular(drawn.wi(), drawn.weight().times(1 / (drawsFirst ? share : 1 - share)));
    } else {
      // Both lobes count for the direction that one of them gave.
      BsdfValue value = new BsdfValue();
      evaluate(wo, drawn.wi(), value);
      drawn.weighBy(value);
    }
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
