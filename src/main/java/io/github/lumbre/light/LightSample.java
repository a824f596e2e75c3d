package io.github.lumbre.light;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.geometry.SurfaceSample;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;

/**
 * A sample of light that may arrive at a point from one direction, or an empty sample. Mutable:
 * each thread reuses one instance.
 */
public final class LightSample {
  /** Where a shadow ray ends. */
  public enum Target {
    /** At a point in space. */
    POINT,
    /** At a point on a light's surface; that surface point does not block its own light. */
    SURFACE,
    /** At infinity. */
    INFINITY
  }

  private double x, y, z = 1;
  private double r, g, b;
  private double pdf;
  private Target target = Target.INFINITY;
  private double endX, endY, endZ;
  private final SurfaceSample surface = new SurfaceSample();

  /** Creates an empty sample. */
  public LightSample() {}

  /** Makes the sample empty: no light can arrive. */
  public void clear() {
    pdf = 0;
  }

  /**
   * Sets light from infinity.
   *
   * @param wi unit direction to the light, in world space
   * @param radiance radiance that arrives along wi if nothing blocks it; for a delta light,
   *     irradiance at normal incidence
   * @param newPdf density per solid angle, &gt; 0; infinite for a delta light
   */
  void setInfinite(Vec3 wi, Rgb radiance, double newPdf) {
    set(wi, radiance, newPdf, Target.INFINITY);
  }

  /**
   * Sets light from a point light, which no scattered ray can hit.
   *
   * @param wi unit direction to the light, in world space
   * @param irradiance irradiance at normal incidence if nothing blocks it
   * @param point position of the light in world space
   */
  void setPoint(Vec3 wi, Rgb irradiance, Vec3 point) {
    set(wi, irradiance, Double.POSITIVE_INFINITY, Target.POINT);
    endX = point.x();
    endY = point.y();
    endZ = point.z();
  }

  /** Sets light from the surface point in {@link #surface}, with that point's density. */
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

  /**
   * Replaces light that arrives from a point of a surface by the same light by way of a mirror or a
   * refracting surface.
   *
   * @param newWi unit direction to the mirror or refracting surface, in world space
   * @param part fraction of the light that goes this way, per color
   * @param newPdf density of that direction per solid angle, &gt; 0
   */
  public void redirect(Vec3 newWi, Rgb part, double newPdf) {
    x = newWi.x();
    y = newWi.y();
    z = newWi.z();
    dim(part);
    pdf = newPdf;
  }

  /** Multiplies the light by a factor ≥ 0; a factor of 0 makes the sample empty. */
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
  public SurfaceSample surface() {
    return surface;
  }

  /** Returns whether no light can arrive. */
  public boolean isEmpty() {
    return pdf == 0;
  }

  /** Returns the unit direction to the light, in world space. */
  public Vec3 wi() {
    return new Vec3(x, y, z);
  }

  /**
   * Returns the radiance that arrives along {@link #wi} if nothing blocks it; for a delta light,
   * the irradiance at normal incidence.
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

  /** Returns the density per solid angle: infinite for a delta light, 0 if the sample is empty. */
  public double pdf() {
    return pdf;
  }

  /** Returns whether the light is a delta light, which no ray can hit. */
  public boolean isDelta() {
    return pdf == Double.POSITIVE_INFINITY;
  }

  /** Returns where the shadow ray ends. */
  public Target target() {
    return target;
  }

  /**
   * Returns the world position at which the shadow ray ends; valid for {@link Target#POINT} only.
   */
  public Vec3 end() {
    return new Vec3(endX, endY, endZ);
  }

  /**
   * Sets {@code shadow} to the shadow ray from a surface to the light: the light arrives if that
   * ray hits nothing.
   */
  public void aimShadowRay(SurfaceHit from, NearestHit shadow) {
    switch (target) {
      case SURFACE -> from.spawnTowards(surface, shadow);
      case POINT -> from.spawnTowards(end(), shadow);
      case INFINITY -> from.spawn(x, y, z, shadow);
    }
  }

  /** Sets {@code shadow} to the ray from a point in space to the light, which must be a surface. */
  public void aimFrom(Vec3 point, NearestHit shadow) {
    surface.aimFrom(point, shadow);
  }
}
