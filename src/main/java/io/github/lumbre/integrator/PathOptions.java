package io.github.lumbre.integrator;

import io.github.lumbre.scene.RenderSettings;
import java.util.Objects;

/**
 * How a {@link PathTracer} looks for light. Depth alone decides what it finds; the others decide
 * how much noise and time that takes.
 *
 * @param maxDepth how many vertices of a path may scatter, at least 0: with 0 only emitters are
 *     seen, with 1 direct light
 * @param firstRoulette number of the first vertex, the one that the camera sees being 0, at which a
 *     weak path may end at random
 * @param split number of branches of each path from its first vertex that is no mirror or clear
 *     glass, at least 1; each counts for its share (PBRT 4e, sec. 2.2.5)
 */
public record PathOptions(
    int maxDepth,
    MisHeuristic heuristic,
    LightSamplerKind lightSampler,
    int firstRoulette,
    int split) {
  /** The first vertex at which roulette may end a path, unless another is set. */
  public static final int FIRST_ROULETTE = 3;

  public PathOptions {
    Objects.requireNonNull(heuristic, "heuristic");
    Objects.requireNonNull(lightSampler, "lightSampler");
    if (maxDepth < 0 || firstRoulette < 0) {
      throw new IllegalArgumentException(
          "maxDepth, firstRoulette: expected at least 0, found " + maxDepth + ", " + firstRoulette);
    }
    if (split < 1) {
      throw new IllegalArgumentException("split: expected at least 1, found " + split);
    }
  }

  /** Returns the options that renders use, for paths of so many scattering vertices at most. */
  public static PathOptions toDepth(int maxDepth) {
    return new PathOptions(maxDepth, MisHeuristic.BOTH, LightSamplerKind.PLACE, FIRST_ROULETTE, 1);
  }

  /** Returns the options by which a render of such settings follows paths. */
  public static PathOptions of(RenderSettings settings) {
    return toDepth(settings.maxTraceDepth()).splitInto(settings.split());
  }

  /** Returns the same with another heuristic. */
  public PathOptions by(MisHeuristic newHeuristic) {
    return new PathOptions(maxDepth, newHeuristic, lightSampler, firstRoulette, split);
  }

  /** Returns the same with another choice of emitters. */
  public PathOptions by(LightSamplerKind newSampler) {
    return new PathOptions(maxDepth, heuristic, newSampler, firstRoulette, split);
  }

  /** Returns the same with another first vertex at which a path may end at random. */
  public PathOptions rouletteFrom(int vertex) {
    return new PathOptions(maxDepth, heuristic, lightSampler, vertex, split);
  }

  /** Returns the same options with another number of branches. */
  public PathOptions splitInto(int ways) {
    return new PathOptions(maxDepth, heuristic, lightSampler, firstRoulette, ways);
  }
}
