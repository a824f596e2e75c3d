package io.github.lumbre.integrator;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.Warp;
import io.github.lumbre.scene.Backplate;
import io.github.lumbre.scene.Scene;

/**
 * The light of a backplate along a camera ray that hits nothing. Where the ray comes down onto the
 * ground below a box that casts a contact shadow, it is less: in proportion to what blocks the sky
 * above that point of the ground, the less the farther away it is. The ground is seen by no other
 * ray. Immutable.
 */
record SeenBackplate(Scene scene, Backplate backplate) {
  /** The rays of a sample: they are short, and fewer leave grain. */
  private static final int RAYS = 4;

  /** The distance from which on nothing casts a shadow, divided by the radius of the box. */
  private static final double REACH = .5;

  /** The part of the light that is missing where all of the sky is blocked. */
  private static final double STRENGTH = .85;

  /** The sine of the angle by which a camera that sees the shadow looks down at least. */
  private static final double FLAT = .02;

  /** The sine of the angle from which on it sees all of it. */
  private static final double RAISED = .12;

  /** The sines of the angles where that ends, and where it is gone: plans show no ground. */
  private static final double STEEP = .9;

  private static final double UPRIGHT = .97;

  /** How far the ground is below the box, divided by its radius, so that it touches no surface. */
  private static final double GAP = 1e-5;

  /**
   * Returns the light.
   *
   * @param context whose hit is the camera ray
   */
  Rgb light(Sampler sampler, RenderContext context) {
    Rgb light = backplate.at(context.down);
    if (backplate.shadowOf().isEmpty()) {
      return light;
    }
    return light.times(1 - shadow(backplate.shadowOf().get(), sampler, context));
  }

  private double shadow(Bounds3 box, Sampler sampler, RenderContext context) {
    Vec3 eye = context.hit.origin();
    Vec3 direction = context.hit.direction();
    double strength = STRENGTH * seen();
    if (!(strength > 0) || !(direction.y() < 0)) {
      return 0;
    }
    double radius = box.radius();
    double ground = box.min().y() - GAP * radius;
    double t = (ground - eye.y()) / direction.y();
    Vec3 point = new Vec3(eye.x() + t * direction.x(), ground, eye.z() + t * direction.z());
    double reach = REACH * radius;
    boolean isSeen = t > 0 && isNear(box, point, reach);
    return isSeen ? strength * blocked(point, reach, sampler, context) : 0;
  }

  /** Returns how much of a shadow the camera sees, 0 to 1. */
  private double seen() {
    double sine = -scene.camera().axes().normal().y();
    return Math.min(between(FLAT, RAISED, sine), 1 - between(STEEP, UPRIGHT, sine));
  }

  private static double between(double low, double high, double x) {
    return Math.max(0, Math.min(1, (x - low) / (high - low)));
  }

  private static boolean isNear(Bounds3 box, Vec3 point, double reach) {
    double x = Math.max(box.min().x() - point.x(), point.x() - box.max().x());
    double z = Math.max(box.min().z() - point.z(), point.z() - box.max().z());
    return x < reach && z < reach;
  }

  /**
   * Returns the part of random rays towards the sky that is blocked. Their lengths are random, so
   * that what is half as far away as the reach blocks half as much.
   */
  private double blocked(Vec3 point, double reach, Sampler sampler, RenderContext context) {
    double blocked = 0;
    for (int ray = 0; ray < RAYS; ray++) {
      int dimension = Sampler.caught(ray);
      Vec3 up = Warp.cosineHemisphere(sampler.get2d(dimension));
      double length = reach * sampler.get1d(dimension + 2);
      blocked += context.blocked(scene, point, new Vec3(up.x(), up.z(), up.y()), length);
    }
    return blocked / RAYS;
  }
}
