package io.github.lumbre.light.internal;

import io.github.lumbre.light.LightBounds;
import java.util.Arrays;
import java.util.List;

/**
 * A tree over many lights at finite distances, which selects a light approximately in proportion to
 * its irradiance at a point. Nodes have up to eight children, so that a traversal visits few nodes
 * and computes the importance of all children of a node in one loop. The time grows with the
 * logarithm of the number of lights. Immutable.
 *
 * <p>From the root on, the traversal descends to a child in proportion to the importance of each
 * (PBRT 4e, sec. 12.6.3, after Conty Estevez &amp; Kulla 2018, there with two children). Their
 * splitting, which samples more than one light, is left out: a vertex samples one light.
 */
final class LightTree implements NearLights {
  private static final double BELOW_ONE = 0x1.fffffffffffffp-1;

  private final LightTreeLayout layout;

  /** The bounds of the root's children, which stand for all lights against those elsewhere. */
  private final LightNodes top;

  /** The bounds of all children. */
  private final LightTreeBounds bounds;

  private final int[] firstChildren;
  private final int[] children;
  private final int[] sizes;

  /**
   * @param items at least one; this constructor reorders the list
   * @param count number of emitters of the scene, greater than every index in {@code items}
   */
  LightTree(List<LightTreeBuilder.Item> items, int count) {
    LightTreeBuilder.Node[] built = LightTreeBuilder.build(items);
    layout = LightTreeLayout.of(built, count);
    LightBounds[] all = layout.bounds();
    bounds = new LightTreeBounds(built[0].bounds().box(), all);
    firstChildren = layout.firstChildren();
    top = new LightNodes(Arrays.copyOf(all, firstChildren[1]));
    children = layout.children();
    sizes = layout.sizes();
  }

  @Override
  public double irradiance(LightChoice receiver) {
    double sum = 0;
    for (int child = 0; child < firstChildren[1]; child++) {
      sum += top.importance(child, receiver);
    }
    return sum;
  }

  @Override
  public void choose(double u, LightChoice choice) {
    double[] weights = choice.weights;
    boolean isEven = u < EVEN_SHARE;
    double rest = isEven ? u / EVEN_SHARE : (u - EVEN_SHARE) / (1 - EVEN_SHARE);
    double probability = 1 - EVEN_SHARE;
    double even = EVEN_SHARE;
    int node = 0;
    while (node >= 0) {
      int first = firstChildren[node];
      int end = firstChildren[node + 1];
      double sum = weigh(first, end, choice);
      double number = lightingEmitters(first, end, weights);
      // Find the child to which the random number belongs. Rounding may leave a remainder after the
      // last child, which then is selected.
      rest *= isEven ? number : sum;
      int chosen = first;
      double share = 0;
      for (int child = first; child < end; child++) {
        double weight = weights[child - first];
        if (weight > 0) {
          chosen = child;
          share = isEven ? sizes[child] : weight;
          if (rest < share) {
            break;
          }
          rest -= share;
        }
      }
      rest = Math.min(rest / share, BELOW_ONE);
      probability *= weights[chosen - first] / sum;
      even *= sizes[chosen] / number;
      node = children[chosen];
    }
    choice.set(~node, even + probability);
  }

  @Override
  public double probability(LightChoice receiver, int emitter) {
    double[] weights = receiver.weights;
    double probability = 1 - EVEN_SHARE;
    double even = EVEN_SHARE;
    int child = layout.leaf(emitter);
    while (child >= 0) {
      int node = layout.node(child);
      int first = firstChildren[node];
      int end = firstChildren[node + 1];
      double sum = weigh(first, end, receiver);
      double weight = weights[child - first];
      if (!(weight > 0)) {
        return 0;
      }
      probability *= weight / sum;
      even *= sizes[child] / lightingEmitters(first, end, weights);
      child = layout.parent(node);
    }
    return even + probability;
  }

  /**
   * Computes the weights of the children of a node, which are their importances; all are 1 if the
   * sum of the importances cannot be used. Returns the sum of the weights.
   */
  private double weigh(int first, int end, LightChoice receiver) {
    double[] weights = receiver.weights;
    double sum = bounds.weigh(first, end, receiver, weights);
    if (NearLights.isUsable(sum)) {
      return sum;
    }
    for (int child = first; child < end; child++) {
      weights[child - first] = 1;
    }
    return end - first;
  }

  /** Returns the number of emitters in those children of a node that can light the point. */
  private double lightingEmitters(int first, int end, double[] weights) {
    int number = 0;
    for (int child = first; child < end; child++) {
      number += weights[child - first] > 0 ? sizes[child] : 0;
    }
    return number;
  }
}
