package io.github.lumbre.geometry;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;

/** Helper functions of shapes that are defined in a local space. */
final class Placement {
  /** A distance far above all rounding errors, relative to the coordinates. */
  private static final double CLEARANCE = 1e-6;

  private Placement() {}

  /**
   * Returns the transform if it is invertible.
   *
   * @throws IllegalArgumentException if it is singular
   */
  static Transform invertible(Transform toWorld) {
    if (!toWorld.isInvertible()) {
      throw new IllegalArgumentException(
          "toWorld: expected an invertible transform, found a singular one");
    }
    return toWorld;
  }

  /**
   * Returns the translation to a point.
   *
   * @throws IllegalArgumentException if a coordinate is not finite
   */
  static Transform at(Vec3 center) {
    return Transform.translation(finite("center", center));
  }

  /**
   * Returns a point if it is finite.
   *
   * @throws IllegalArgumentException if it is not
   */
  static Vec3 finite(String name, Vec3 point) {
    if (!point.isFinite()) {
      throw new IllegalArgumentException(name + ": expected finite numbers, found " + point);
    }
    return point;
  }

  /**
   * Returns a world-space box that contains the image of a local box, including rounding errors.
   */
  static Bounds3 outward(Transform toWorld, Bounds3 local) {
    if (local.isEmpty()) {
      return Bounds3.EMPTY;
    }
    return widened(toWorld.bounds(local), toWorld, farthest(local));
  }

  /**
   * Returns a box widened by the rounding error of mapped points. {@code farthest} holds the
   * largest absolute local coordinates of these points.
   */
  static Bounds3 widened(Bounds3 world, Transform toWorld, Vec3 farthest) {
    Vec3 margin =
        new Vec3(
            toWorld.pointError(farthest, Vec3.X),
            toWorld.pointError(farthest, Vec3.Y),
            toWorld.pointError(farthest, Vec3.Z));
    return new Bounds3(world.min().minus(margin), world.max().plus(margin));
  }

  /**
   * Returns whether a box lies wholly on the side of the local xz plane that +y points to, not
   * nearer than {@link #CLEARANCE}. False for infinite boxes.
   */
  static boolean isInFront(Bounds3 box, Transform toWorld) {
    Vec3 normal = toWorld.normal(Vec3.Y);
    Vec3 origin = toWorld.point(Vec3.ZERO);
    double margin = CLEARANCE * (farthest(box).maxAbs() + origin.maxAbs());
    for (int corner = 0; corner < 8; corner++) {
      if (!(box.corner(corner).minus(origin).dot(normal) > margin)) {
        return false;
      }
    }
    return true;
  }

  private static Vec3 farthest(Bounds3 box) {
    return new Vec3(
        Math.max(Math.abs(box.min().x()), Math.abs(box.max().x())),
        Math.max(Math.abs(box.min().y()), Math.abs(box.max().y())),
        Math.max(Math.abs(box.min().z()), Math.abs(box.max().z())));
  }

  /**
   * Returns the density per solid angle of a point that was sampled uniformly by area.
   *
   * @param toReference from the point to the reference point, not normalized
   * @param normal the unit normal at the point
   * @return distance² / (|cos| area); 0 where the surface is seen edge-on or at distance 0
   */
  static double solidAnglePdf(Vec3 toReference, Vec3 normal, double area) {
    double distance = toReference.length();
    double cos = Math.abs(toReference.dot(normal)) / distance;
    double pdf = distance / cos * (distance / area);
    return cos > 0 && pdf < Double.POSITIVE_INFINITY ? pdf : 0;
  }
}
