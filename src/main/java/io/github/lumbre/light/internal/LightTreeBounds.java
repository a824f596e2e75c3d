package io.github.lumbre.light.internal;

import io.github.lumbre.light.LightBounds;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;

/**
 * The bounds of the nodes of a {@link LightTree} in a flat array of floats, from which the
 * importance of several nodes to a point is computed in one loop. Immutable.
 *
 * <p>Importances approximate {@link LightNodes#importance}, in another unit. Most lights are
 * surfaces with equal normals in a node, whose importance needs no square root: with the squared
 * distance d², the vector v from the node's center to the point, and the radius r of its bounding
 * sphere, it is I (r − v·n) (r + v·a) / d⁴, where n is the point's normal and a the axis of the
 * lights' normals.
 *
 * <p>Positions are relative to the box of all nodes, so that floats have enough range and precision
 * in every scene. The radius of each node includes the rounding errors of positions, so that the
 * bounds stay conservative.
 */
final class LightTreeBounds {
  // Offsets of a node's values in the array.
  private static final int CENTER = 0;
  private static final int RADIUS = 3;
  private static final int AXIS = 4;
  private static final int COS_SPREAD = 7;
  private static final int SIN_SPREAD = 8;
  private static final int COS_FALL = 9;
  private static final int INTENSITY = 10;

  /** Not 0 if normals differ, or if light stays within a cone around them. */
  private static final int IS_WIDE = 11;

  private static final int STRIDE = 12;

  /** Tolerance for rounding of the cosines that decide whether a node can light the point. */
  private static final float ROUNDING = 1e-6f;

  /**
   * A bound of the rounding error of the distance between a point and a center, both at most 2 from
   * the origin. Points farther away have a larger error, which the tolerance of cosines covers.
   */
  private static final double POSITION_ERROR = 0x1p-20;

  /**
   * Points farther away than this are moved nearer: the directions to all nodes are nearly equal.
   */
  private static final double FAR = 1e5;

  private final float[] nodes;
  private final Vec3 origin;
  private final double scale;

  /**
   * Creates the bounds of nodes.
   *
   * @param all bounds of all lights
   */
  LightTreeBounds(Bounds3 all, LightBounds... bounds) {
    origin = all.center();
    double radius = all.radius();
    scale = radius > Double.MIN_NORMAL ? 1 / radius : 1;
    nodes = new float[STRIDE * bounds.length];
    for (int node = 0; node < bounds.length; node++) {
      put(STRIDE * node, bounds[node]);
    }
  }

  private void put(int at, LightBounds bounds) {
    Vec3 center = bounds.box().center().minus(origin).times(scale);
    for (int axis = 0; axis < 3; axis++) {
      nodes[at + CENTER + axis] = (float) center.get(axis);
      nodes[at + AXIS + axis] = (float) bounds.axis().get(axis);
    }
    nodes[at + RADIUS] = (float) (bounds.box().radius() * scale * (1 + 0x1p-20) + POSITION_ERROR);
    boolean isAllAround = bounds.spread() >= Math.PI;
    double spread = bounds.spread() / Elementary.TWO_PI;
    nodes[at + COS_SPREAD] = isAllAround ? -1 : (float) Elementary.cosTurns(spread);
    nodes[at + SIN_SPREAD] = isAllAround ? 0 : (float) Elementary.sinTurns(spread);
    double cosFall = Elementary.cosTurns(bounds.fall() / Elementary.TWO_PI);
    nodes[at + COS_FALL] = (float) cosFall - 2 * ROUNDING;
    boolean isFlat = !isAllAround && Elementary.sinTurns(spread) < ROUNDING && cosFall < ROUNDING;
    nodes[at + IS_WIDE] = isFlat ? 0 : 1;
    nodes[at + INTENSITY] = (float) bounds.intensity();
  }

  /**
   * Computes the importances of consecutive nodes. Each is positive if any light in the node can
   * light the point.
   *
   * @param first the first node
   * @param end the last node, excluded; at most {@link LightChoice#WEIGHTS} after the first
   * @param weights receives the importances
   * @return their sum
   */
  double weigh(int first, int end, LightChoice receiver, double[] weights) {
    double px = (receiver.x - origin.x()) * scale;
    double py = (receiver.y - origin.y()) * scale;
    double pz = (receiver.z - origin.z()) * scale;
    double reach = Math.max(Math.abs(px), Math.max(Math.abs(py), Math.abs(pz)));
    if (reach > FAR) {
      px = px / reach * FAR;
      py = py / reach * FAR;
      pz = pz / reach * FAR;
    }
    return weigh(first, end, (float) px, (float) py, (float) pz, receiver, weights);
  }

  private double weigh(
      int first, int end, float px, float py, float pz, LightChoice receiver, double[] weights) {
    float[] p = nodes;
    float normalX = (float) receiver.normalX;
    float normalY = (float) receiver.normalY;
    float normalZ = (float) receiver.normalZ;
    // An open point receives light from all directions.
    boolean isOpen = receiver.isOpen();
    double sum = 0;
    for (int node = first, at = first * STRIDE; node < end; node++, at += STRIDE) {
      float x = px - p[at + CENTER];
      float y = py - p[at + CENTER + 1];
      float z = pz - p[at + CENTER + 2];
      float radius = p[at + RADIUS];
      float squared = x * x + y * y + z * z;
      float weight = p[at + INTENSITY];
      if (squared > radius * radius) {
        // Both cosines are multiplied by the distance.
        float received = radius - (x * normalX + y * normalY + z * normalZ);
        float emitted = radius + x * p[at + AXIS] + y * p[at + AXIS + 1] + z * p[at + AXIS + 2];
        if (isOpen || p[at + IS_WIDE] != 0) {
          float distance = (float) Math.sqrt(squared);
          received += isOpen ? distance : 0;
          emitted = withCone(at, radius, emitted - radius, distance);
        }
        float inverse = 1 / squared;
        // A tolerance of more than ROUNDING times the distance.
        float least = -ROUNDING * (1 + squared);
        weight =
            received > least && emitted > least
                ? weight * inverse * (factor(received) * factor(emitted) * inverse)
                : 0;
      } else {
        weight /= radius * radius;
      }
      weights[node - first] = weight;
      sum += weight;
    }
    return sum;
  }

  /**
   * Returns the bound of the emitted cosine, times the distance, of a node whose lights have
   * different normals or emit into a cone; a negative number if they emit nothing to the point.
   *
   * @param at offset of the node in the array
   * @param along cosine of the angle to the axis of the normals, times the distance
   */
  private float withCone(int at, float radius, float along, float distance) {
    float cosSpread = nodes[at + COS_SPREAD];
    float across = (float) Math.sqrt(Math.max(0, distance * distance - along * along));
    float emitted =
        along < cosSpread * distance
            ? radius + along * cosSpread + across * nodes[at + SIN_SPREAD]
            : radius + distance;
    return emitted > nodes[at + COS_FALL] * distance ? emitted : Float.NEGATIVE_INFINITY;
  }

  private static float factor(float cosine) {
    return cosine > ROUNDING ? cosine : ROUNDING;
  }
}
