package io.github.lumbre.light.internal;

import io.github.lumbre.light.LightBounds;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;

/**
 * Light bounds in a flat array, from which the importance of each node to a point is computed.
 * Immutable.
 */
final class LightNodes {
  // Offsets of a node's values in the array.
  private static final int CENTER = 0;
  private static final int RADIUS = 3;
  private static final int AXIS = 4;
  private static final int COS_SPREAD = 7;
  private static final int SIN_SPREAD = 8;
  private static final int COS_FALL = 9;
  private static final int INTENSITY = 10;
  private static final int STRIDE = 11;

  /** Tolerance for rounding of the cosines that decide whether a node can light the point. */
  private static final double ROUNDING = 1e-8;

  private final double[] nodes;

  LightNodes(LightBounds... bounds) {
    nodes = new double[STRIDE * bounds.length];
    for (int node = 0; node < bounds.length; node++) {
      put(STRIDE * node, bounds[node]);
    }
  }

  private void put(int at, LightBounds bounds) {
    Vec3 center = bounds.box().center();
    double radius = bounds.box().radius();
    for (int axis = 0; axis < 3; axis++) {
      nodes[at + CENTER + axis] = center.get(axis);
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
   * Returns an estimate of the irradiance from a node; positive if any of its emitters can light
   * the point.
   *
   * <p>Seen from the point, the node's bounding sphere covers a half angle b. The angle a to the
   * cone of emitter normals, and the angle a to the receiver's normal, may therefore be smaller by
   * b. The exact bound is cos(a − b) = cos a cos b + sin a sin b. The code uses cos a + sin b,
   * which is close for small b and needs no square root.
   */
  double importance(int node, LightChoice receiver) {
    int at = STRIDE * node;
    double x = receiver.x - nodes[at + CENTER];
    double y = receiver.y - nodes[at + CENTER + 1];
    double z = receiver.z - nodes[at + CENTER + 2];
    double distanceSquared = x * x + y * y + z * z;
    double radius = nodes[at + RADIUS];
    if (!(distanceSquared > radius * radius)) {
      return nodes[at + INTENSITY] / (radius * radius);
    }
    double perDistance = 1 / Math.sqrt(distanceSquared);
    double sin = radius * perDistance;
    double along =
        -perDistance * (x * receiver.normalX + y * receiver.normalY + z * receiver.normalZ);
    // An open point receives light from all directions.
    double received = receiver.isOpen() ? 1 : along + sin;
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

  /**
   * Returns the cosine of the angle between the direction to a point and a node's cone of normals;
   * 1 inside the cone.
   *
   * @param at offset of the node in the array
   * @param cos cosine of the angle between that direction and the axis of the cone
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
