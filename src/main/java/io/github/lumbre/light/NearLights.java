package io.github.lumbre.light;

/** Emitters of limited reach, of which a point sees others than its neighbour. Immutable. */
sealed interface NearLights permits FewLights, LightTree {
  /**
   * The share of choices that all emitters have alike: nothing is known of what stands between them
   * and the point.
   */
  double EVEN_SHARE = .125;

  /**
   * Returns about the irradiance that a point may have from all of them; 0 if they leave it dark.
   */
  double irradiance(LightChoice receiver);

  /** Chooses an emitter; see {@link LightSampler#choose}. */
  void choose(double u, LightChoice choice);

  /** Returns the probability with which {@link #choose} finds an emitter. */
  double probability(LightChoice receiver, int emitter);
}
