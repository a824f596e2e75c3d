package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;

/**
 * The sum of two lobes, which must not reflect more than 1 together: one is drawn, in proportion to
 * its importance, and both count for the direction it gives.
 */
record Mixture(Lobe first, Lobe second) implements Bsdf {
  @Override
  public double pdf(Vec3 wo, Vec3 wi) {
    double share = shareOfFirst(wo.z());
    return share * first.pdf(wo, wi) + (1 - share) * second.pdf(wo, wi);
  }

  @Override
  public void evaluate(BsdfValue value) {
    double share = shareOfFirst(value.cosine());
    first.evaluate(value);
    Rgb f = value.f();
    double pdf = share * value.pdf();
    second.evaluate(value);
    value.set(f.plus(value.f()), pdf + (1 - share) * value.pdf());
  }

  @Override
  public boolean choosesLobe() {
    return true;
  }

  @Override
  public void sample(BsdfSample drawn) {
    double share = shareOfFirst(drawn.cosine());
    boolean drawsFirst = drawn.uLobe() < share;
    Lobe chosen = drawsFirst ? first : second;
    if (!chosen.draw(drawn)) {
      drawn.absorb();
    } else if (chosen.isSpecular()) {
      drawn.setSpecular(drawn.wi(), drawn.weight().times(1 / (drawsFirst ? share : 1 - share)));
    } else {
      // Both lobes count for the direction that one of them gave.
      drawn.weighBy(this);
    }
  }

  private double shareOfFirst(double cosine) {
    double one = first.importance(cosine);
    double sum = one + second.importance(cosine);
    return sum == 0 ? .5 : one / sum;
  }

  @Override
  public Rgb diffuseAlbedo() {
    return first.diffuseAlbedo().plus(second.diffuseAlbedo());
  }
}
