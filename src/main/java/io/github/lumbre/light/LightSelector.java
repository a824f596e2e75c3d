package io.github.lumbre.light;

import io.github.lumbre.sampling.Distribution1d;

/** Which of a scene's emitters a point asks for light: a fixed choice at random. Immutable. */
public final class LightSelector {
  /**
   * The share of choices that all emitters have alike. What is near and weak can matter more than
   * what is far and strong; so no emitter is chosen less than half as often as by pure chance.
   */
  private static final double EVEN_SHARE = .5;

  private final Distribution1d distribution;

  private LightSelector(Distribution1d distribution) {
    this.distribution = distribution;
  }

  /**
   * Returns the selector that makes half of its choices in proportion to power and half evenly.
   *
   * @param powers at least one; each at least 0; if any is infinite, all choices are even
   */
  public static LightSelector byPower(double... powers) {
    double sum = 0;
    for (double power : powers) {
      sum += power;
    }
    double[] weights = new double[powers.length];
    for (int i = 0; i < powers.length; i++) {
      double even = 1.0 / powers.length;
      boolean known = sum > 0 && Double.isFinite(sum);
      weights[i] = EVEN_SHARE * even + (1 - EVEN_SHARE) * (known ? powers[i] / sum : even);
    }
    return new LightSelector(new Distribution1d(weights));
  }

  /** Returns the index of an emitter, chosen by a uniform number in [0,1). */
  public int choose(double u) {
    return distribution.choose(u);
  }

  /** Returns the probability with which {@link #choose} returns an index; positive. */
  public double probability(int index) {
    return distribution.probability(index);
  }
}
