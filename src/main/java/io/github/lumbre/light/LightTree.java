package io.github.lumbre.light;

import io.github.lumbre.math.Elementary;
import io.github.lumbre.math.Vec3;
import java.util.List;

/**
 * A hierarchy of emitters of limited reach: a choice at random among many of them, about in
 * proportion to the light that each may send to a point, in a time that grows with the logarithm of
 * their number. Immutable.
 *
 * <p>From the root on, the way goes left or right in proportion to bounds of the light from either
 * side: PBRT 4e, sec. 12.6.3, after Conty Estevez &amp; Kulla 2018. Their splitting, which asks
 * more than one emitter, is left out: a vertex asks for one.
 */
final class LightTree {
  // What is stored of a node.
  private static final int CENTRE = 0;
  private static final int RADIUS = 3;
  private static final int AXIS = 4;
  private static final int COS_SPREAD = 7;
  private static final int SIN_SPREAD = 8;
  private static final int COS_FALL = 9;
  private static final int INTENSITY = 10;
  private static final int SHARE_OF_PARENT = 11;
  private static final int STRIDE = 12;

  /** Where a cosine that decides about darkness counts as rounded. */
  private static final double ROUNDING = 1e-8;

  /**
   * The share of choices that all emitters have alike: the tree knows nothing of what stands
   * between them and the point.
   */
  private static final double EVEN_SHARE = .125;

  private static final double BELOW_ONE = 0x1.fffffffffffffp-1;

  private final double[] nodes;

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
    nodes = new double[STRIDE * built.length];
    children = new int[built.length];
    parents = new int[built.length];
    leaves = new int[count];
    for (int node = 0; node < built.length; node++) {
      put(STRIDE * node, built[node].bounds());
      parents[node] = built[node].parent();
      children[node] = built[node].child();
      nodes[STRIDE * node + SHARE_OF_PARENT] =
          (double) built[node].size() / built[parents[node]].size();
      if (children[node] < 0) {
        leaves[~children[node]] = node;
      }
    }
  }

  private void put(int at, LightBounds bounds) {
    Vec3 centre = bounds.box().centre();
    double radius = bounds.box().radius();
    for (int axis = 0; axis < 3; axis++) {
      nodes[at + CENTRE + axis] = centre.get(axis);
      nodes[at + AXIS + axis] = bounds.axis().get(axis);
    }
    nodes[at + RADIUS] = radius;
    boolean isAllAround = bounds.spread() >= Math.PI;
    double spread = bounds.spread() / Elementary.TWO_PI;
    nodes[at + COS_SPREAD] = isAllAround ? -1 : Elementary.cosTurns(spread);
    nodes[at + SIN_SPREAD] = isAllAround ? 0 : Elementary.sinTurns(spread);
    nodes[at + COS_FALL] = Elementary.cosTurns(bounds.fall() / Elementary.TWO_PI) - ROUNDING;
    nodes[at + INTENSITY] = bounds.intensity();
  }

  /**
   * Chooses an emitter; see {@link LightSelector#choose}.
   *
   * @param before the probability of coming here at all
   */
  LightSelector.Choice choose(Vec3 point, Vec3 normal, double u, double before) {
    boolean isEven = u < EVEN_SHARE;
    double rest = isEven ? u / EVEN_SHARE : (u - EVEN_SHARE) / (1 - EVEN_SHARE);
    double probability = 1 - EVEN_SHARE;
    double even = EVEN_SHARE;
    int node = 0;
    while (children[node] > 0) {
      int left = children[node];
      double share = leftShare(left, point, normal);
      double byNumber = evenShare(left, share);
      double threshold = isEven ? byNumber : share;
      boolean goesLeft = rest < threshold;
      rest = goesLeft ? rest / threshold : (rest - threshold) / (1 - threshold);
      rest = Math.min(rest, BELOW_ONE);
      node = goesLeft ? left : left + 1;
      probability *= goesLeft ? share : 1 - share;
      even *= goesLeft ? byNumber : 1 - byNumber;
    }
    return new LightSelector.Choice(~children[node], before * (even + probability));
  }

  /** Returns the probability with which {@link #choose} returns an index of the tree. */
  double probability(Vec3 point, Vec3 normal, int emitter) {
    double probability = 1 - EVEN_SHARE;
    double even = EVEN_SHARE;
    for (int node = leaves[emitter]; node > 0; node = parents[node]) {
      // Left children have odd numbers.
      boolean isLeft = (node & 1) != 0;
      int left = isLeft ? node : node - 1;
      double share = leftShare(left, point, normal);
      double byNumber = evenShare(left, share);
      probability *= isLeft ? share : 1 - share;
      even *= isLeft ? byNumber : 1 - byNumber;
    }
    return even + probability;
  }

  /** Returns the probability to go left: a half where nothing can be said. */
  private double leftShare(int left, Vec3 point, Vec3 normal) {
    double one = importance(STRIDE * left, point, normal);
    double other = importance(STRIDE * left + STRIDE, point, normal);
    double share = one / (one + other);
    return share >= 0 ? share : .5;
  }

  /** Returns the probability to go left by the number of emitters, but never into darkness. */
  private double evenShare(int left, double share) {
    return share > 0 && share < 1 ? nodes[STRIDE * left + SHARE_OF_PARENT] : share;
  }

  /**
   * Returns about the irradiance from a node: positive if any of its emitters can light the point.
   *
   * <p>The node's sphere covers a half angle b, by which the cone of normals may be closer to the
   * point, and the sphere's direction to the point's normal: of the cosine of such an angle less b,
   * cos a cos b + sin a sin b, the bound cos a + sin b is good where b is small and takes no root.
   */
  private double importance(int at, Vec3 point, Vec3 normal) {
    double x = point.x() - nodes[at + CENTRE];
    double y = point.y() - nodes[at + CENTRE + 1];
    double z = point.z() - nodes[at + CENTRE + 2];
    double distanceSquared = x * x + y * y + z * z;
    double radius = nodes[at + RADIUS];
    if (!(distanceSquared > radius * radius)) {
      return nodes[at + INTENSITY] / (radius * radius);
    }
    double perDistance = 1 / Math.sqrt(distanceSquared);
    double sin = radius * perDistance;
    double along = -perDistance * (x * normal.x() + y * normal.y() + z * normal.z());
    // A zero normal takes light from everywhere.
    double received = isZero(normal) ? 1 : along + sin;
    if (!(received > -ROUNDING)) {
      return 0;
    }
    double emitted =
        sin
            + cosToCone(
                at,
                perDistance
                    * (x * nodes[at + AXIS] + y * nodes[at + AXIS + 1] + z * nodes[at + AXIS + 2]));
    if (!(emitted > nodes[at + COS_FALL])) {
      return 0;
    }
    return nodes[at + INTENSITY]
        * (perDistance * perDistance)
        * Math.max(Math.min(received, 1), ROUNDING)
        * Math.max(Math.min(emitted, 1), ROUNDING);
  }

  private static boolean isZero(Vec3 normal) {
    return normal.x() == 0 && normal.y() == 0 && normal.z() == 0;
  }

  /**
   * Returns the cosine of the angle between the way to a point and a node's cone of normals.
   *
   * @param cos of the angle between the way and the cone's axis
   */
  private double cosToCone(int at, double cos) {
    double cosSpread = nodes[at + COS_SPREAD];
    if (cos >= cosSpread) {
      return 1;
    }
    double sinSpread = nodes[at + SIN_SPREAD];
    return sinSpread < ROUNDING
        ? cos * cosSpread + sinSpread
        : cos * cosSpread + Elementary.safeSqrt(1 - cos * cos) * sinSpread;
  }
}
