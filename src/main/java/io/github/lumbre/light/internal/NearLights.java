package io.github.lumbre.light.internal;

/**
 * A light sampler for emitters whose irradiance decreases with distance, so that their importance
 * depends on the point. Immutable.
 */
sealed interface NearLights permits FewLights, LightTree {
  /**
   * The fraction of choices that is spread evenly over all emitters that can light the point,
   * because occlusion is unknown.
   */
  double EVEN_SHARE = .125;

  /**
   * Returns an estimate of the irradiance at a point from all the emitters; 0 if none can light it.
   */
  double irradiance(LightChoice receiver);

  /** Selects an emitter; see {@link LightSampler#choose}. */
  void choose(double u, LightChoice choice);

  /** Returns the probability with which {@link #choose} selects an emitter. */
  double probability(LightChoice receiver, int emitter);

  /**
   * Returns whether a sum of weights can be used. At the position of a point light the weight is
   * infinite, and the reciprocal of a subnormal sum may overflow.
   */
  static boolean isUsable(double sum) {
    return sum >= Double.MIN_NORMAL && sum < Double.POSITIVE_INFINITY;
  }
}
