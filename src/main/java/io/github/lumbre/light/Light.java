package io.github.lumbre.light;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import java.util.Optional;

/** Something that emits and can be sampled. Immutable. */
public sealed interface Light
    permits PointLight, SpotLight, DirectionalLight, AreaLight, EnvironmentLight {
  /**
   * Samples light that may arrive at a point, or none. This is the hot path: plain numbers and a
   * reused result allocate nothing; {@link #sample(Vec3, Point2)} is the same for other callers.
   *
   * @param x of the reference point, in world space, as are y and z
   * @param u uniform in [0,1), as is v: they determine the light's point or direction; delta lights
   *     ignore them
   * @param result receives the light, {@linkplain LightSample#isEmpty empty} if none can arrive
   */
  void sample(double x, double y, double z, double u, double v, LightSample result);

  /**
   * Samples light that may arrive at a point; empty if none can arrive.
   *
   * @param reference point in world space
   * @param u uniform in [0,1)²: determines the light's point or direction
   */
  default Optional<LightSample> sample(Vec3 reference, Point2 u) {
    LightSample result = new LightSample();
    sample(reference.x(), reference.y(), reference.z(), u.x(), u.y(), result);
    return result.isEmpty() ? Optional.empty() : Optional.of(result);
  }

  /**
   * Returns the density, per solid angle at a reference point, with which {@link #sample} draws the
   * point of the light that a ray from there hit; 0 for lights that no ray can hit.
   *
   * @param reference point in world space
   * @param hit on the light's surface, found by a ray from the reference point
   */
  default double pdf(Vec3 reference, SurfaceHit hit) {
    return 0;
  }

  /**
   * Returns the density per solid angle with which {@link #sample} draws a direction along which
   * the light arrives from infinity; 0 for lights at a finite distance and for delta lights.
   *
   * @param direction unit, in world space, towards the light
   */
  default double pdf(Vec3 direction) {
    return 0;
  }

  /**
   * Returns about how much power the light sends into the scene, by its strongest colour component:
   * a weight for choosing among lights, not a quantity to compute with.
   *
   * @param sceneRadius of a sphere around all that is finite in the scene, at least 0
   */
  double power(double sceneRadius);

  /**
   * Returns where the light comes from and goes to, or empty if distance does not weaken it: then
   * it reaches all of the scene alike.
   */
  default Optional<LightBounds> bounds() {
    return Optional.empty();
  }

  /**
   * Returns about the irradiance from a light that distance does not weaken, by its strongest
   * colour component: a weight, to be compared with what {@link #bounds} say of other lights; 0 of
   * those.
   */
  default double farIrradiance() {
    return 0;
  }

  /** Returns whether the light emits nothing at all, so that it need never be chosen. */
  boolean isBlack();

  /** Returns whether the light is of no size, so that no scattered ray can hit it. */
  default boolean isDelta() {
    return true;
  }
}
