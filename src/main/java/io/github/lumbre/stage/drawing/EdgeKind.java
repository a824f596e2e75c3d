package io.github.lumbre.stage.drawing;

import io.github.lumbre.geometry.internal.MeshEdges;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;

/**
 * Decides which edges are lines. The decisions do not depend on the order of the vertices of a
 * triangle, which many files have wrong.
 */
final class EdgeKind {
  /** The sine of an angle between a triangle and the view that rounding makes. */
  private static final double EDGE_ON = 1e-12;

  /** The angle from which on an edge between smooth normals is a crease, in degrees. */
  private static final double SMOOTH_DEGREES = 60;

  /**
   * Angles that differ by less than this count as equal, in degrees: files round positions, so that
   * the angles of a regular prism are not the same.
   */
  private static final double EQUAL_DEGREES = .05;

  /** More than rounding adds to the cosine of the angle between triangles that are no slivers. */
  private static final double ROUNDING = 1e-6;

  /** The squared sine, at a corner of a triangle, below which it is a sliver. */
  private static final double SLIVER = 1e-8;

  /** Products of four squared lengths below this may have lost digits. */
  private static final double LEAST = 1e-280;

  private final MeshEdges edges;
  private final double[] positions;
  private final double cosCrease;
  private final double cosSmooth;

  /**
   * @param positions of the places of the edges, in world space
   * @param creaseDegrees angle between two triangles from which on their edge is a crease
   */
  EdgeKind(MeshEdges edges, double[] positions, double creaseDegrees) {
    this.edges = edges;
    this.positions = positions;
    cosCrease = cosCrease(creaseDegrees);
    cosSmooth = cosCrease(Math.max(creaseDegrees, SMOOTH_DEGREES));
  }

  /**
   * Returns the cosine of the angle between two triangles below which the surface continues: a
   * little less than an angle that is a crease, so that rounding does not decide at this angle.
   */
  static double cosCrease(double creaseDegrees) {
    return Elementary.cosDegrees(creaseDegrees - EQUAL_DEGREES);
  }

  Vec3 from(int edge) {
    return place(edges.from(edge));
  }

  Vec3 to(int edge) {
    return place(edges.to(edge));
  }

  /** Returns the unit direction of an edge. */
  Vec3 along(int edge) {
    return to(edge).minus(from(edge)).normalized();
  }

  private Vec3 place(int place) {
    return new Vec3(positions[3 * place], positions[3 * place + 1], positions[3 * place + 2]);
  }

  /** Returns whether an edge is a border or a crease, or a silhouette for an eye. */
  boolean isLine(int edge, Eye eye) {
    return edges.from(edge) != edges.to(edge) && (isFeature(edge) || isSilhouette(edge, eye));
  }

  /** Returns whether only one triangle has an edge. */
  boolean isBorder(int edge) {
    return edges.triangles(edge) == 1;
  }

  /**
   * Returns whether an edge is a border or a crease: its triangles do not continue each other in
   * two opposite directions. Triangles on the first one do not count.
   */
  boolean isFeature(int edge) {
    if (isSurelyFlat(edge)) {
      return false;
    }
    Vec3 along = along(edge);
    Vec3 first = Vec3.ZERO;
    double flat = edges.isSmooth(edge) ? cosSmooth : cosCrease;
    boolean continues = false;
    for (int i = 0; i < edges.triangles(edge); i++) {
      Vec3 across = across(edge, i, along);
      if (first.equals(Vec3.ZERO)) {
        first = across;
      }
      double cos = first.dot(across);
      boolean isContinued = across.maxAbs() > 0 && -cos > flat;
      if (across.maxAbs() > 0 && !isContinued && cos < Math.abs(flat)) {
        return true;
      }
      continues |= isContinued;
    }
    return !continues;
  }

  /**
   * Returns whether the two triangles of an edge continue each other by more than rounding could
   * change. Nearly all edges of a large mesh do, and this needs no square root.
   */
  private boolean isSurelyFlat(int edge) {
    if (edges.triangles(edge) != 2) {
      return false;
    }
    Vec3 from = from(edge);
    Vec3 along = to(edge).minus(from);
    Vec3 one = place(edges.opposite(edge, 0)).minus(from);
    Vec3 other = place(edges.opposite(edge, 1)).minus(from);
    double squared = along.dot(along);
    double oneAlong = one.dot(along);
    double otherAlong = other.dot(along);
    // Of the directions across the edge: their product, and the product of their lengths squared.
    double product = one.dot(other) * squared - oneAlong * otherAlong;
    double oneLength = one.dot(one) * squared - oneAlong * oneAlong;
    double otherLength = other.dot(other) * squared - otherAlong * otherAlong;
    double lengths = oneLength * otherLength;
    double flat = Math.max(0, edges.isSmooth(edge) ? cosSmooth : cosCrease) + ROUNDING;
    return product < 0
        && product * product > flat * flat * lengths
        && oneLength > SLIVER * one.dot(one) * squared
        && otherLength > SLIVER * other.dot(other) * squared
        && lengths > LEAST;
  }

  /**
   * Returns the unit direction in a triangle that is away from an edge and perpendicular to it;
   * zero for a triangle without an area.
   */
  Vec3 across(int edge, int triangle, Vec3 along) {
    if (isOnEdge(edge, edges.opposite(edge, triangle))) {
      return Vec3.ZERO;
    }
    Vec3 side = place(edges.opposite(edge, triangle)).minus(from(edge));
    Vec3 across = side.plus(-side.dot(along), along);
    return across.maxAbs() > 0 ? across.normalized() : Vec3.ZERO;
  }

  /** Returns whether a place is an end of an edge, as in slivers whose corners became one place. */
  private boolean isOnEdge(int edge, int place) {
    return place == edges.from(edge) || place == edges.to(edge);
  }

  /**
   * Returns whether all triangles of an edge are on the same side of it in the picture. Those that
   * are seen from their edge, but for rounding, are on none.
   */
  boolean isSilhouette(int edge, Eye eye) {
    Vec3 from = from(edge);
    Vec3 normal = eye.rayTo(from).cross(to(edge).minus(from));
    boolean isLeft = false;
    boolean isRight = false;
    for (int i = 0; i < edges.triangles(edge); i++) {
      int opposite = edges.opposite(edge, i);
      Vec3 beside = isOnEdge(edge, opposite) ? Vec3.ZERO : place(opposite).minus(from);
      double side = normal.dot(beside);
      double rounding = EDGE_ON * normal.length() * beside.length();
      isLeft |= side > rounding;
      isRight |= side < -rounding;
    }
    return !(isLeft && isRight);
  }
}
