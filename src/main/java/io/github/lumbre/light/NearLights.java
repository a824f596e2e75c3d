package io.github.lumbre.light;

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
}
