package io.github.lumbre.light;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.light.internal.ProfileLight;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.Optional;

/** A light that can be sampled. Immutable. */
public sealed interface Light
    permits PointLight, SpotLight, ProfileLight, DirectionalLight, AreaLight, EnvironmentLight {
  /**
   * Samples light that may arrive at a point. This method is for the hot path: with plain numbers
   * and a reused result it allocates nothing. Other callers use {@link #sample(Vec3, Point2)}.
   *
   * @param x x coordinate of the reference point in world space, as are y and z
   * @param u uniform in [0,1), as is v; the two determine the point on the light or the direction,
   *     and delta lights ignore them
   * @param result receives the sample; it is {@linkplain LightSample#isEmpty empty} if no light can
   *     arrive
   */
  void sample(double x, double y, double z, double u, double v, LightSample result);

  /**
   * Returns a sample of light that may arrive at a point; empty if no light can arrive.
   *
   * @param reference point in world space
   * @param u uniform in [0,1)²: determines the point on the light or the direction
   */
  default Optional<LightSample> sample(Vec3 reference, Point2 u) {
    LightSample result = new LightSample();
    sample(reference.x(), reference.y(), reference.z(), u.x(), u.y(), result);
    return result.isEmpty() ? Optional.empty() : Optional.of(result);
  }

  /**
   * Returns the density, per solid angle at a reference point, with which {@link #sample} draws the
   * point where a ray from there hit the light; 0 for lights that no ray can hit.
   *
   * @param reference point in world space
   * @param hit hit of a ray from the reference point on the light's surface
   */
  default double pdf(Vec3 reference, SurfaceHit hit) {
    return 0;
  }

  /**
   * Returns the density per solid angle with which {@link #sample} draws a direction along which
   * the light arrives from infinity; 0 for lights at a finite distance and for delta lights.
   *
   * @param direction unit direction towards the light, in world space
   */
  default double pdf(Vec3 direction) {
    return 0;
  }

  /**
   * Returns this light after a further transform. Its strength stays.
   *
   * @param outer invertible
   * @throws IllegalArgumentException if the transform is singular, or the light is an environment
   *     light
   */
  Light transformed(Transform outer);

  /**
   * Returns an estimate of the power that the light sends into the scene, using the largest color
   * component. It serves only as a weight for selecting lights.
   *
   * @param sceneRadius radius of a sphere around all finite objects of the scene, at least 0
   */
  double power(double sceneRadius);

  /**
   * Returns bounds of the light's position, directions and intensity; empty if its irradiance does
   * not decrease with distance, so that it reaches the whole scene equally.
   */
  default Optional<LightBounds> bounds() {
    return Optional.empty();
  }

  /**
   * Returns an estimate of the irradiance from a light that does not decrease with distance, using
   * the largest color component; 0 for lights that have {@link #bounds}. It serves as a weight
   * against the irradiance from lights with bounds.
   */
  default double farIrradiance() {
    return 0;
  }

  /** Returns whether the light is known to emit nothing, so that it never needs to be selected. */
  boolean isBlack();

  /**
   * Returns whether this is a delta light, which has no size, so that no scattered ray can hit it.
   */
  default boolean isDelta() {
    return true;
  }
}
