package io.github.lumbre.stage.drawing;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.Scene;
import java.util.function.Predicate;

/** Finds by rays whether a point of an edge is hidden. Mutable; for one thread. */
final class Occlusion {
  /** Surfaces this near in front of a point do not hide it, relative to the scene's radius. */
  private static final double NEAR = 1e-5;

  /** The most surfaces that a ray passes. */
  private static final int MOST_PASSED = 1000;

  private final Scene scene;
  private final Eye eye;
  private final double near;
  private final NearestHit hit = new NearestHit();

  Occlusion(Scene scene, Eye eye) {
    this.scene = scene;
    this.eye = eye;
    near = NEAR * scene.radius();
  }

  /**
   * Returns whether a surface is in front of a point.
   *
   * @param isOwn returns whether a hit is on a surface that has the point, and does not count
   */
  boolean hides(Vec3 point, Predicate<NearestHit> isOwn) {
    Vec3 ray = eye.rayTo(point);
    double length = ray.length();
    if (!(length > near)) {
      return false;
    }
    Vec3 start = point.minus(ray);
    Vec3 unit = ray.times(1 / length);
    hit.aim(start.x(), start.y(), start.z(), unit.x(), unit.y(), unit.z(), length - near);
    for (int passed = 0; passed < MOST_PASSED && scene.intersect(hit); passed++) {
      if (!isOwn.test(hit) && isOpaque(scene, hit)) {
        return true;
      }
      hit.pass();
    }
    return false;
  }

  /** Finds the nearest surface on a ray that is opaque to the camera; returns whether one is. */
  static boolean findOpaque(Scene scene, NearestHit ray) {
    for (int passed = 0; passed < MOST_PASSED && scene.intersect(ray); passed++) {
      if (isOpaque(scene, ray)) {
        return true;
      }
      ray.pass();
    }
    return false;
  }

  /** Returns whether the hit surface is opaque to the camera. */
  private static boolean isOpaque(Scene scene, NearestHit hit) {
    Primitive primitive = scene.primitiveAt(hit);
    return !primitive.material().catchesShadows()
        && (primitive.material().isOpaque()
            || primitive.material().transmittance(scene.surfaceAt(hit)).max() < .5);
  }
}
