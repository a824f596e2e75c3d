package io.github.lumbre.stage.drawing;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Scene;

/**
 * Finds by rays where the surface continues beyond an edge that only one triangle has, because
 * corners of other triangles lie within the edge (T-junctions). Mutable; for one thread.
 */
final class Seams {
  /** How far beside an edge the surface is sought, relative to the scene's radius. */
  private static final double BESIDE = 1e-4;

  /** The most surfaces that a ray passes. */
  private static final int MOST_PASSED = 100;

  private final Scene scene;
  private final Eye eye;
  private final double beside;
  private final double cosCrease;
  private final NearestHit hit = new NearestHit();

  /**
   * @param creaseDegrees angle between two triangles from which on their edge is a crease
   */
  Seams(Scene scene, Eye eye, double creaseDegrees) {
    this.scene = scene;
    this.eye = eye;
    beside = BESIDE * scene.radius();
    cosCrease = EdgeKind.cosCrease(creaseDegrees);
  }

  /**
   * Returns whether a triangle of the same part continues the triangle of an edge, with neither a
   * crease nor a silhouette between them.
   *
   * @param point on the edge
   * @param along unit direction of the edge
   * @param across unit direction in the triangle away from the edge; zero if there is none
   */
  boolean continues(Vec3 point, OutlinedPart part, Vec3 along, Vec3 across) {
    Vec3 normal = across.cross(along);
    Vec3 start = point.plus(-beside, across).plus(beside, normal);
    hit.aim(start.x(), start.y(), start.z(), -normal.x(), -normal.y(), -normal.z(), 2 * beside);
    for (int passed = 0; passed < MOST_PASSED && scene.intersect(hit); passed++) {
      if (part.has(hit) && isSmooth(normal, point)) {
        return true;
      }
      hit.pass();
    }
    return false;
  }

  /** Returns whether the hit surface and one with a normal are about in one plane for the eye. */
  private boolean isSmooth(Vec3 normal, Vec3 point) {
    Vec3 other = scene.surfaceAt(hit).geometricNormal();
    double cos = normal.dot(other);
    Vec3 ray = eye.rayTo(point);
    return Math.abs(cos) >= cosCrease && ray.dot(normal) * ray.dot(other) * cos > 0;
  }
}
