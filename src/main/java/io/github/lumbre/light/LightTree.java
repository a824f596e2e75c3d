package io.github.lumbre.light;

import java.util.Arrays;
import java.util.List;

/**
 * A binary tree over many lights at finite distances, which selects a light approximately in
 * proportion to its irradiance at a point. The time grows with the logarithm of the number of
 * lights. Immutable.
 *
 * <p>From the root on, the traversal descends to the left or right child in proportion to the
 * importance of each (PBRT 4e, sec. 12.6.3, after Conty Estevez &amp; Kulla 2018). Their splitting,
 * which samples more than one light, is left out: a vertex samples one light.
 */
final class LightTree implements NearLights {
  private static final double BELOW_ONE = 0x1.fffffffffffffp-1;

  private final LightNodes nodes;

  /** The number of emitters in each node, relative to that of its parent. */
  private final double[] shareOfParent;

  /** The index of each node's left child, which the right one follows; for a leaf, ~emitter. */
  private final int[] children;

  private final int[] parents;

  /** The index of the leaf of each emitter in the tree. */
  private final int[] leaves;

  /**
   * @param items at least one; this constructor reorders the list
   * @param count number of emitters of the scene, greater than every index in {@code items}
   */
  LightTree(List<LightTreeBuilder.Item> items, int count) {
    LightTreeBuilder.Node[] built = LightTreeBuilder.build(items);
    nodes =
        new LightNodes(
            Arrays.stream(built).map(LightTreeBuilder.Node::bounds).toArray(LightBounds[]::new));
    shareOfParent = new double[built.length];
    children = new int[built.length];
    parents = new int[built.length];
    leaves = new int[count];
    for (int node = 0; node < built.length; node++) {
      parents[node] = built[node].parent();
      children[node] = built[node].child();
      shareOfParent[node] = (double) built[node].size() / built[parents[node]].size();
      if (children[node] < 0) {
        leaves[~children[node]] = node;
      }
    }
  }

  @Override
  public double irradiance(LightChoice receiver) {
    int left = children[0];
    return nodes.importance(left, receiver) + nodes.importance(left + 1, receiver);
  }

  @Override
  public void choose(double u, LightChoice choice) {
    boolean isEven = u < EVEN_SHARE;
    double rest = isEven ? u / EVEN_SHARE : (u - EVEN_SHARE) / (1 - EVEN_SHARE);
    double probability = 1 - EVEN_SHARE;
    double even = EVEN_SHARE;
    int node = 0;
    while (children[node] > 0) {
      int left = children[node];
      double share = leftShare(left, choice);
      double byNumber = evenShare(left, share);
      double threshold = isEven ? byNumber : share;
      boolean goesLeft = rest < threshold;
      rest = goesLeft ? rest / threshold : (rest - threshold) / (1 - threshold);
      rest = Math.min(rest, BELOW_ONE);
      node = goesLeft ? left : left + 1;
      probability *= goesLeft ? share : 1 - share;
      even *= goesLeft ? byNumber : 1 - byNumber;
    }
    choice.set(~children[node], even + probability);
  }

  @Override
  public double probability(LightChoice receiver, int emitter) {
    double probability = 1 - EVEN_SHARE;
    double even = EVEN_SHARE;
    for (int node = leaves[emitter]; node > 0; node = parents[node]) {
      // Left children have odd indices.
      boolean isLeft = (node & 1) != 0;
      int left = isLeft ? node : node - 1;
      double share = leftShare(left, receiver);
      double byNumber = evenShare(left, share);
      probability *= isLeft ? share : 1 - share;
      even *= isLeft ? byNumber : 1 - byNumber;
    }
    return even + probability;
  }

  /**
   * Returns the probability of descending to the left child; 0.5 where the sum of the importances
   * is 0 or infinite.
   */
  private double leftShare(int left, LightChoice receiver) {
    double one = nodes.importance(left, receiver);
    double other = nodes.importance(left + 1, receiver);
    double sum = one + other;
    return sum > 0 && sum < Double.POSITIVE_INFINITY ? one / sum : .5;
  }

  /**
   * Returns the probability of descending to the left child by the number of emitters, but never to
   * a child that cannot light the point.
   */
  private double evenShare(int left, double share) {
    return share > 0 && share < 1 ? shareOfParent[left] : share;
  }
}
