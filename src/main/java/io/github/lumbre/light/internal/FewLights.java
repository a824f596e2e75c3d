package io.github.lumbre.light.internal;

import io.github.lumbre.light.LightBounds;
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

  /**
   * Computes the weights of all lights at a point. The lights of one point are usually asked for
   * several times, so that the point keeps its weights.
   */
  private void weigh(LightChoice receiver) {
    if (receiver.weighedBy == this) {
      return;
    }
    double sum = 0;
    int lit = 0;
    for (int i = 0; i < emitters.length; i++) {
      double weight = nodes.importance(i, receiver);
      receiver.weights[i] = weight;
      sum += weight;
      lit += weight > 0 ? 1 : 0;
    }
    receiver.sum = sum;
    receiver.lit = lit;
    receiver.weighedBy = this;
  }

  @Override
  public double irradiance(LightChoice receiver) {
    weigh(receiver);
    return receiver.sum;
  }

  @Override
  public void choose(double u, LightChoice choice) {
    weigh(choice);
    double[] weights = choice.weights;
    int count = emitters.length;
    if (!NearLights.isUsable(choice.sum)) {
      choice.set(emitters[(int) (u * count)], 1.0 / count);
      return;
    }
    double scale = (1 - EVEN_SHARE) / choice.sum;
    double even = EVEN_SHARE / choice.lit;
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
    weigh(receiver);
    if (!NearLights.isUsable(receiver.sum)) {
      return 1.0 / emitters.length;
    }
    double own = receiver.weights[places[emitter]];
    return own > 0 ? (1 - EVEN_SHARE) / receiver.sum * own + EVEN_SHARE / receiver.lit : 0;
  }
}
