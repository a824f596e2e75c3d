package io.github.lumbre.integrator;

import io.github.lumbre.integrator.guiding.Guide;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.material.BsdfValue;

/** How a path chooses the direction in which it leaves a vertex. Immutable. */
interface DirectionStrategy {
  /** Returns the strategy that follows a guide where it has learned directions. */
  static DirectionStrategy of(PathOptions options, Guide guide) {
    BsdfDirections alone = new BsdfDirections(options.firstRoulette());
    return guide.isEmpty() ? alone : new GuidedDirections(guide, alone);
  }

  /** Prepares a vertex that the path has reached. */
  void reach(Vertex vertex);

  /**
   * Samples a direction in which the path leaves a vertex.
   *
   * @param uLobe uniform in [0,1); selects a lobe of the BSDF
   * @param u uniform in [0,1), as is v; the two determine the direction
   * @param context receives the direction in {@code scattered}, in world space; a delta lobe has an
   *     infinite density
   */
  void sample(Vertex vertex, double uLobe, double u, double v, RenderContext context);

  /**
   * Replaces the density of BSDF sampling by the density with which {@link #sample} draws the
   * direction of a light.
   */
  void weigh(Vertex vertex, LightSample light, BsdfValue value);

  /**
   * Returns the probability with which Russian roulette continues the path after {@link #sample}.
   *
   * @param depth number of the vertex, from 0
   * @param path with the throughput behind the vertex
   */
  double survival(Vertex vertex, int depth, Path path);
}
