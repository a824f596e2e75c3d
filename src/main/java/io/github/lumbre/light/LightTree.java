package io.github.lumbre.light;

import java.util.Arrays;
import java.util.List;

/**
 * A hierarchy of emitters of limited reach: a choice at random among many of them, about in
 * proportion to the light that each may send to a point, in a time that grows with the logarithm of
 * their number. Immutable.
 *
 * <p>From the root on, the way goes left or right in proportion to bounds of the light from either
 * side: PBRT 4e, sec. 12.6.3, after Conty Estevez &amp; Kulla 2018. Their splitting, which samples
 * more than one emitter, is left out: a vertex samples one.
 */
final class LightTree implements NearLights {
  private static final double BELOW_ONE = 0x1.fffffffffffffp-1;

  private final LightNodes nodes;

  /** The number of emitters in each node relative to its parent's. */
  private final double[] shareOfParent;

  /** The left child of each node, beside which lies the right one; of a leaf, ~emitter. */
  private final int[] children;

  private final int[] parents;

  /** The leaf of each emitter that is in the tree. */
  private final int[] leaves;

  /**
   * @param items at least one; sorted on the way
   * @param count above the largest of the items' indices
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
      // Left children have odd numbers.
      boolean isLeft = (node & 1) != 0;
      int left = isLeft ? node : node - 1;
      double share = leftShare(left, receiver);
      double byNumber = evenShare(left, share);
      probability *= isLeft ? share : 1 - share;
      even *= isLeft ? byNumber : 1 - byNumber;
    }
    return even + probability;
  }

  /** Returns the probability to go left: a half where nothing can be said. */
  private double leftShare(int left, LightChoice receiver) {
    double one = nodes.importance(left, receiver);
    double other = nodes.importance(left + 1, receiver);
    double share = one / (one + other);
    return share >= 0 ? share : .5;
  }

  /** Returns the probability to go left by the number of emitters, but never into darkness. */
  private double evenShare(int left, double share) {
    return share > 0 && share < 1 ? shareOfParent[left] : share;
  }
}
