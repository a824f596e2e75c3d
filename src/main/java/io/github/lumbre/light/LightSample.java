package io.github.lumbre.light;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.geometry.SurfaceSample;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;

/**
 * Light that may arrive at a point from one direction.
 *
 * @param wi unit direction to the light
 * @param radiance arriving along wi if nothing is in between; of a delta light, irradiance at
 *     normal incidence
 * @param pdf density per solid angle; of a delta light, infinite
 * @param target where the shadow ray ends
 */
public record LightSample(Vec3 wi, Rgb radiance, double pdf, Target target) {

  /** Where a shadow ray ends: at a point, at a surface, or nowhere. */
  public sealed interface Target permits AtPoint, AtSurface, AtInfinity {}

  /** A point in space. */
  public record AtPoint(Vec3 position) implements Target {}

  /** A point of a light's surface, which does not block its own light. */
  public record AtSurface(SurfaceSample sample) implements Target {}

  /** Infinitely far in the direction wi. */
  public enum AtInfinity implements Target {
    INSTANCE
  }

  /** Tells whether the light can only be sampled, and never be hit by a ray. */
  public boolean isDelta() {
    return pdf == Double.POSITIVE_INFINITY;
  }

  /** Aims a search by the ray that must meet nothing for the light to arrive. */
  public void aimShadowRay(SurfaceHit from, NearestHit shadow) {
    if (target instanceof AtSurface surface) {
      from.spawnTowards(surface.sample(), shadow);
    } else if (target instanceof AtPoint point) {
      from.spawnTowards(point.position(), shadow);
    } else {
      from.spawn(wi, shadow);
    }
  }
}
