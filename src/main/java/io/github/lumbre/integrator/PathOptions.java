package io.github.lumbre.integrator;

import java.util.Objects;

/**
 * How a {@link PathTracer} looks for light. Depth alone decides what it finds; the others decide
 * how much noise and time that takes.
 *
 * @param maxDepth how many vertices of a path may scatter, at least 0: with 0 only emitters are
 *     seen, with 1 direct light
 * @param firstRoulette number of the first vertex, the one that the camera sees being 0, at which a
 *     weak path may end at random
 */
public record PathOptions(int maxDepth, Strategy strategy, Selection selection, int firstRoulette) {
  /** The first vertex at which a path may end, unless another is asked for. */
  public static final int FIRST_ROULETTE = 3;

  public PathOptions {
    Objects.requireNonNull(strategy, "strategy");
    Objects.requireNonNull(selection, "selection");
    if (maxDepth < 0 || firstRoulette < 0) {
      throw new IllegalArgumentException(
          "maxDepth, firstRoulette: expected at least 0, found " + maxDepth + ", " + firstRoulette);
    }
  }

  /** Returns the options that renders use, for paths of so many scattering vertices at most. */
  public static PathOptions toDepth(int maxDepth) {
    return new PathOptions(maxDepth, Strategy.BOTH, Selection.PLACE, FIRST_ROULETTE);
  }

  /** Returns the same with another strategy. */
  public PathOptions by(Strategy newStrategy) {
    return new PathOptions(maxDepth, newStrategy, selection, firstRoulette);
  }

  /** Returns the same with another choice of emitters. */
  public PathOptions by(Selection newSelection) {
    return new PathOptions(maxDepth, strategy, newSelection, firstRoulette);
  }

  /** Returns the same with another first vertex at which a path may end at random. */
  public PathOptions rouletteFrom(int vertex) {
    return new PathOptions(maxDepth, strategy, selection, vertex);
  }
}
