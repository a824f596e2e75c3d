package io.github.lumbre.integrator;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Backplate;
import io.github.lumbre.scene.Scene;
import java.util.Optional;

/**
 * The light of a backplate along a camera ray that hits nothing. Where the ray comes down onto the
 * ground below a box that casts a contact shadow, it is less. The ground is seen by no other ray.
 */
final class SeenBackplate {
  /** The part of the light that is missing where all of the sky is blocked. */
  private static final double STRENGTH = .85;

  /** The sine of the angle by which a camera that sees the shadow looks down at least. */
  private static final double FLAT = .02;

  /** The sine of the angle from which on it sees all of it. */
  private static final double RAISED = .12;

  /** The sines of the angles where that ends, and where it is gone: plans show no ground. */
  private static final double STEEP = .9;

  private static final double UPRIGHT = .97;

  private final Backplate backplate;
  private final Optional<ContactShadow> shadow;
  private final double strength;

  SeenBackplate(Scene scene, Backplate backplate) {
    this.backplate = backplate;
    strength = STRENGTH * seen(-scene.camera().axes().normal().y());
    shadow =
        backplate
            .shadowOf()
            .filter(box -> strength > 0 && box.radius() > 0)
            .map(box -> new ContactShadow(scene, box));
  }

  /** Returns how much of a shadow a camera sees that looks down by an angle of this sine. */
  private static double seen(double sine) {
    return Math.min(between(FLAT, RAISED, sine), 1 - between(STEEP, UPRIGHT, sine));
  }

  private static double between(double low, double high, double x) {
    return Math.max(0, Math.min(1, (x - low) / (high - low)));
  }

  /**
   * Returns the light.
   *
   * @param context whose hit is the camera ray
   */
  Rgb light(RenderContext context) {
    Rgb light = backplate.at(context.down);
    return shadow.isEmpty() ? light : light.times(1 - strength * blocked(shadow.get(), context));
  }

  private static double blocked(ContactShadow shadow, RenderContext context) {
    Vec3 eye = context.hit.origin();
    Vec3 direction = context.hit.direction();
    double t = (shadow.ground() - eye.y()) / direction.y();
    return direction.y() < 0 && t > 0
        ? shadow.at(eye.x() + t * direction.x(), eye.z() + t * direction.z(), context)
        : 0;
  }
}
