package io.github.lumbre.light;

import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.geometry.SurfaceSample;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.Objects;
import java.util.Optional;

/**
 * A shape that emits light. The scene also contains it as a primitive with the same emission, which
 * rays can hit.
 *
 * @param shape shape of finite area, in world space
 * @param emission radiance that its surface emits
 */
public record AreaLight(Shape shape, Emission emission) implements Light {
  public AreaLight {
    Objects.requireNonNull(shape, "shape");
    Objects.requireNonNull(emission, "emission");
  }

  @Override
  public void sample(double x, double y, double z, double u, double v, LightSample result) {
    SurfaceSample point = result.surface();
    shape.sample(x, y, z, u, v, point);
    result.clear();
    if (!(point.pdf() > 0)) {
      return;
    }
    Vec3 reference = new Vec3(x, y, z);
    Rgb radiance = emission.towards(reference, point);
    if (!radiance.isBlack()) {
      result.setSurface(point.position().minus(reference).normalized(), radiance);
    }
  }

  @Override
  public AreaLight transformed(Transform outer) {
    return new AreaLight(shape.transformed(outer), emission);
  }

  @Override
  public double pdf(Vec3 reference, SurfaceHit hit) {
    return shape.pdf(reference, hit);
  }

  @Override
  public double power(double sceneRadius) {
    return emission.meanRadiance() * Math.PI * shape.area() * (emission.twoSided() ? 2 : 1);
  }

  /**
   * {@inheritDoc}
   *
   * <p>The mean projected area of a convex body is a quarter of its surface area (Cauchy 1832).
   */
  @Override
  public Optional<LightBounds> bounds() {
    double strongest = emission.meanRadiance() * shape.area();
    Optional<Vec3> normal = emission.twoSided() ? Optional.empty() : shape.onlyNormal();
    return Optional.of(
        normal
            .map(n -> LightBounds.towards(shape.bounds(), n, 0, .5 * Math.PI, strongest))
            .orElseGet(() -> LightBounds.allAround(shape.bounds(), .25 * strongest)));
  }

  @Override
  public boolean isBlack() {
    return emission.isBlack();
  }

  @Override
  public boolean isDelta() {
    return false;
  }
}
