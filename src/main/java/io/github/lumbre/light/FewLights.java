package io.github.lumbre.light;

import java.util.List;

/**
 * A few emitters of limited reach, each weighted by its own bounds. With four that takes less time
 * than a {@link LightTree}, and tells more than bounds of pairs. Immutable.
 */
final class FewLights implements NearLights {
  /** The largest number of emitters that are weighted one by one. */
  static final int MOST = LightChoice.WEIGHTS;

  private final LightNodes nodes;
  private final int[] emitters;

  /** Where each emitter stands in the list. */
  private final int[] places;

  /**
   * @param items at least one, at most {@link #MOST}
   * @param count above the largest of the items' indices
   */
  FewLights(List<LightTreeBuilder.Item> items, int count) {
    nodes =
        new LightNodes(
            items.stream().map(LightTreeBuilder.Item::bounds).toArray(LightBounds[]::new));
    emitters = items.stream().mapToInt(LightTreeBuilder.Item::emitter).toArray();
    places = new int[count];
    for (int place = 0; place < emitters.length; place++) {
      places[emitters[place]] = place;
    }
  }

  @Override
  public double irradiance(LightChoice receiver) {
    double sum = 0;
    for (int i = 0; i < emitters.length; i++) {
      sum += nodes.importance(i, receiver);
    }
    return sum;
  }

  @Override
  public void choose(double u, LightChoice choice) {
    double[] weights = choice.weights;
    int count = emitters.length;
    double sum = 0;
    int lit = 0;
    for (int i = 0; i < count; i++) {
      double weight = nodes.importance(i, choice);
      weights[i] = weight;
      sum += weight;
      lit += weight > 0 ? 1 : 0;
    }
    if (!isUsable(sum)) {
      choice.set(emitters[(int) (u * count)], 1.0 / count);
      return;
    }
    double scale = (1 - EVEN_SHARE) / sum;
    double even = EVEN_SHARE / lit;
    double rest = u;
    int chosen = -1;
    double probability = 0;
    // Rounding may leave a rest after the last of them, which then has it.
    for (int i = 0; i < count && rest >= 0; i++) {
      if (weights[i] > 0) {
        chosen = i;
        probability = scale * weights[i] + even;
        rest -= probability;
      }
    }
    choice.set(emitters[chosen], probability);
  }

  @Override
  public double probability(LightChoice receiver, int emitter) {
    double sum = 0;
    int lit = 0;
    double own = 0;
    for (int i = 0; i < emitters.length; i++) {
      double weight = nodes.importance(i, receiver);
      sum += weight;
      lit += weight > 0 ? 1 : 0;
      own = i == places[emitter] ? weight : own;
    }
    if (!isUsable(sum)) {
      return 1.0 / emitters.length;
    }
    return own > 0 ? (1 - EVEN_SHARE) / sum * own + EVEN_SHARE / lit : 0;
  }

  /**
   * Returns whether a sum of weights is usable: in a light of no size one is infinite, and the
   * reciprocal of what is below normal numbers overflows.
   */
  private static boolean isUsable(double sum) {
    return sum >= Double.MIN_NORMAL && sum < Double.POSITIVE_INFINITY;
  }
}
