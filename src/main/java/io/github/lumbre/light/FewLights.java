package io.github.lumbre.light;

import java.util.List;

/**
 * A light sampler for a few lights at finite distances, which weights each light by its own bounds.
 * For four lights it is faster than a {@link LightTree}, and more accurate, because bounds of pairs
 * are looser. Immutable.
 */
final class FewLights implements NearLights {
  /** The largest number of lights. */
  static final int MOST = LightChoice.WEIGHTS;

  private final LightNodes nodes;
  private final int[] emitters;

  /** The position in {@link #emitters} of each emitter of the scene. */
  private final int[] places;

  /**
   * @param items at least one, at most {@link #MOST}
   * @param count number of emitters of the scene, greater than every index in {@code items}
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
    if (!NearLights.isUsable(sum)) {
      choice.set(emitters[(int) (u * count)], 1.0 / count);
      return;
    }
    double scale = (1 - EVEN_SHARE) / sum;
    double even = EVEN_SHARE / lit;
    double rest = u;
    int chosen = -1;
    double probability = 0;
    // Rounding may leave a remainder after the last light, which then is selected.
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
    if (!NearLights.isUsable(sum)) {
      return 1.0 / emitters.length;
    }
    return own > 0 ? (1 - EVEN_SHARE) / sum * own + EVEN_SHARE / lit : 0;
  }
}
