package io.github.lumbre.integrator;

import io.github.lumbre.light.LightSample;
import io.github.lumbre.material.BsdfValue;

/**
 * Directions that the BSDF alone determines.
 *
 * @param firstRoulette number of the first vertex at which Russian roulette may end a path
 */
record BsdfDirections(int firstRoulette) implements DirectionStrategy {
  @Override
  public void reach(Vertex vertex) {
    // The vertex knows its BSDF.
  }

  @Override
  public void sample(Vertex vertex, double uLobe, double u, double v, RenderContext context) {
    vertex.sample(uLobe, u, v, context.scratch.scattered);
  }

  @Override
  public void weigh(Vertex vertex, LightSample light, BsdfValue value) {
    // The value has the density of BSDF sampling.
  }

  @Override
  public double survival(Vertex vertex, int depth, Path path) {
    return depth >= firstRoulette ? path.survival(depth) : 1;
  }
}
