package io.github.lumbre.light;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.internal.Directions;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.Objects;

/**
 * Parallel light from infinity.
 *
 * @param direction unit direction in which the light travels, in world space
 * @param irradiance irradiance at normal incidence, linear RGB
 */
public record DirectionalLight(Vec3 direction, Rgb irradiance) implements Light {
  public DirectionalLight {
    Objects.requireNonNull(direction, "direction");
    Objects.requireNonNull(irradiance, "irradiance");
  }

  @Override
  public void sample(double x, double y, double z, double u, double v, LightSample result) {
    result.setInfinite(direction.negated(), irradiance, Double.POSITIVE_INFINITY);
  }

  /**
   * Returns light that travels in a direction.
   *
   * @param direction of any length
   * @param irradiance irradiance at normal incidence, linear RGB
   * @throws IllegalArgumentException if the direction is zero or not finite
   */
  public static DirectionalLight along(Vec3 direction, Rgb irradiance) {
    return new DirectionalLight(Directions.unit("direction", direction), irradiance);
  }

  @Override
  public DirectionalLight transformed(Transform outer) {
    return new DirectionalLight(
        Directions.axis(outer.times(Directions.pointing(Vec3.ZERO, direction))), irradiance);
  }

  @Override
  public double power(double sceneRadius) {
    return irradiance.max() * Math.PI * sceneRadius * sceneRadius;
  }

  @Override
  public double farIrradiance() {
    return irradiance.max();
  }

  @Override
  public boolean isBlack() {
    return irradiance.isBlack();
  }
}
