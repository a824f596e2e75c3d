package io.github.lumbre.light;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.Objects;
import java.util.Optional;

/**
 * A point light that emits equally in all directions.
 *
 * @param position in world space
 * @param intensity in linear RGB; its unit depends on the falloff
 * @param falloff how the irradiance depends on distance
 */
public record PointLight(Vec3 position, Rgb intensity, Falloff falloff) implements Light {
  /**
   * Returns a light whose irradiance falls with the square of the distance.
   *
   * @param intensity radiant intensity in linear RGB
   */
  public static PointLight of(Vec3 position, Rgb intensity) {
    return new PointLight(position, intensity, Falloff.INVERSE_SQUARE);
  }

  public PointLight {
    Objects.requireNonNull(position, "position");
    Objects.requireNonNull(intensity, "intensity");
    Objects.requireNonNull(falloff, "falloff");
  }

  @Override
  public void sample(double x, double y, double z, double u, double v, LightSample result) {
    Vec3 way = position.minus(new Vec3(x, y, z));
    double distanceSquared = way.lengthSquared();
    if (distanceSquared == 0) {
      result.clear();
    } else {
      result.setPoint(way.normalized(), falloff.irradiance(intensity, distanceSquared), position);
    }
  }

  @Override
  public PointLight transformed(Transform outer) {
    return new PointLight(outer.point(position), intensity, falloff);
  }

  @Override
  public double power(double sceneRadius) {
    return intensity.max() * falloff.sphere(sceneRadius);
  }

  @Override
  public Optional<LightBounds> bounds() {
    return falloff == Falloff.NONE
        ? Optional.empty()
        : Optional.of(LightBounds.allAround(Bounds3.of(position), intensity.max()));
  }

  @Override
  public double farIrradiance() {
    return falloff == Falloff.NONE ? intensity.max() : 0;
  }

  @Override
  public boolean isBlack() {
    return intensity.isBlack();
  }
}
