package io.github.lumbre.light;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.geometry.SurfaceSample;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;

/**
 * Light that may arrive at a point from one direction, or none. Mutable: each thread reuses one
 * instance.
 */
public final class LightSample {
  /** Where a shadow ray ends. */
  public enum Target {
    /** At a point in space. */
    POINT,
    /** At a point of a light's surface, which does not block its own light. */
    SURFACE,
    /** Nowhere. */
    INFINITY
  }

  private double x, y, z = 1;
  private double r, g, b;
  private double pdf;
  private Target target = Target.INFINITY;
  private double endX, endY, endZ;
  private final SurfaceSample surface = new SurfaceSample();

  /** Makes a sample of no light. */
  public LightSample() {}

  /** Sets the sample to none: no light can arrive. */
  public void clear() {
    pdf = 0;
  }

  /**
   * Sets light from infinitely far.
   *
   * @param wi unit direction to the light
   * @param radiance arriving along wi if nothing is in between; of a delta light, irradiance at
   *     normal incidence
   * @param newPdf density per solid angle, &gt; 0; of a delta light, infinite
   */
  void setInfinite(Vec3 wi, Rgb radiance, double newPdf) {
    set(wi, radiance, newPdf, Target.INFINITY);
  }

  /**
   * Sets light from a point, which no scattered ray can hit.
   *
   * @param wi unit direction to the light
   * @param irradiance at normal incidence
   */
  void setPoint(Vec3 wi, Rgb irradiance, Vec3 point) {
    set(wi, irradiance, Double.POSITIVE_INFINITY, Target.POINT);
    endX = point.x();
    endY = point.y();
    endZ = point.z();
  }

  /** Sets light from the point that stands in {@link #surface}, with its density. */
  void setSurface(Vec3 wi, Rgb radiance) {
    set(wi, radiance, surface.pdf(), Target.SURFACE);
  }

  private void set(Vec3 wi, Rgb radiance, double newPdf, Target newTarget) {
    x = wi.x();
    y = wi.y();
    z = wi.z();
    r = radiance.r();
    g = radiance.g();
    b = radiance.b();
    pdf = newPdf;
    target = newTarget;
  }

  /** Weakens the light, if there is any, by a factor ≥ 0; by 0 none is left. */
  void dim(double factor) {
    r *= factor;
    g *= factor;
    b *= factor;
    if (factor == 0) {
      clear();
    }
  }

  /** Weakens the light, if there is any, by a factor for each color. */
  public void dim(Rgb factor) {
    r *= factor.r();
    g *= factor.g();
    b *= factor.b();
  }

  /** Returns the point of the light's surface: memory for sampling it. */
  SurfaceSample surface() {
    return surface;
  }

  /** Returns whether no light can arrive. */
  public boolean isEmpty() {
    return pdf == 0;
  }

  /** Returns the unit direction to the light. */
  public Vec3 wi() {
    return new Vec3(x, y, z);
  }

  /**
   * Returns what arrives along {@link #wi} if nothing is in between: radiance, or of a delta light
   * irradiance at normal incidence.
   */
  public Rgb radiance() {
    return new Rgb(r, g, b);
  }

  /** Returns the red component of {@link #radiance}. */
  public double r() {
    return r;
  }

  /** Returns the green component of {@link #radiance}. */
  public double g() {
    return g;
  }

  /** Returns the blue component of {@link #radiance}. */
  public double b() {
    return b;
  }

  /** Returns the density per solid angle; of a delta light, infinite; of no light, 0. */
  public double pdf() {
    return pdf;
  }

  /** Returns whether the light can only be sampled, and never be hit by a ray. */
  public boolean isDelta() {
    return pdf == Double.POSITIVE_INFINITY;
  }

  /** Returns where the shadow ray ends. */
  public Target target() {
    return target;
  }

  /** Returns the point at which the shadow ray ends, if it ends at one in space. */
  public Vec3 end() {
    return new Vec3(endX, endY, endZ);
  }

  /** Aims a search along the ray that must hit nothing for the light to arrive. */
  public void aimShadowRay(SurfaceHit from, NearestHit shadow) {
    switch (target) {
      case SURFACE -> from.spawnTowards(surface, shadow);
      case POINT -> from.spawnTowards(end(), shadow);
      case INFINITY -> from.spawn(x, y, z, shadow);
    }
  }
}
