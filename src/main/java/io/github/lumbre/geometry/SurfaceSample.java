package io.github.lumbre.geometry;

import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.TexturePoint;

/**
 * A point sampled on the surface of a shape, in world space, or no point if the shape is not
 * visible. Mutable; each thread reuses one instance.
 */
public final class SurfaceSample extends AttributedPoint {
  /** A bound of the position error of a hit, relative to the length of the ray. */
  private static final double ROUNDING = 16 * 0x1p-52;

  private double x, y, z;
  private double normalX, normalY, normalZ = 1;
  private double error;
  private double pdf;

  /** Creates an instance without a point. */
  public SurfaceSample() {}

  /** Removes the point: the shape is not visible. */
  public void clear() {
    pdf = 0;
  }

  /**
   * Sets the sampled point.
   *
   * @param position on the surface, in world space
   * @param normal the outward geometric unit normal at the point
   * @param texture the texture coordinates at the point
   * @param newError a bound of the position's distance from the true surface along the normal
   * @param newPdf the density per solid angle at the reference point, &gt; 0
   */
  public void set(
      Vec3 position, Vec3 normal, TexturePoint texture, double newError, double newPdf) {
    x = position.x();
    y = position.y();
    z = position.z();
    normalX = normal.x();
    normalY = normal.y();
    normalZ = normal.z();
    u = texture.u();
    v = texture.v();
    error = newError;
    pdf = newPdf;
    hasAttributes = false;
  }

  /** Returns the sampled position; undefined without a point. */
  public Vec3 position() {
    return new Vec3(x, y, z);
  }

  /** Returns the outward geometric unit normal at the point. */
  public Vec3 normal() {
    return new Vec3(normalX, normalY, normalZ);
  }

  /** Returns whether a world-space point lies on the side that the normal points to. */
  public boolean isSeenFrontally(Vec3 from) {
    return (from.x() - x) * normalX + (from.y() - y) * normalY + (from.z() - z) * normalZ > 0;
  }

  /**
   * Returns a bound of the position's distance from the true surface along the normal, in world
   * units.
   */
  public double error() {
    return error;
  }

  /** Returns the density per solid angle at the reference point; 0 if there is no point. */
  public double pdf() {
    return pdf;
  }

  /**
   * Returns how far along the normal a shadow ray from a point ends before the surface, so that the
   * surface does not block it; negative on the back.
   */
  double sideTowards(double fromX, double fromY, double fromZ) {
    double wx = fromX - x;
    double wy = fromY - y;
    double wz = fromZ - z;
    double margin = error + ROUNDING * Math.max(Math.abs(wx), Math.max(Math.abs(wy), Math.abs(wz)));
    return Math.copySign(margin, wx * normalX + wy * normalY + wz * normalZ);
  }

  /**
   * Aims {@code next} along the ray from a point in space to the sampled point. The ray ends just
   * before the surface, with t = 1.
   */
  public void aimFrom(Vec3 point, NearestHit next) {
    double side = sideTowards(point.x(), point.y(), point.z());
    next.aim(
        point.x(),
        point.y(),
        point.z(),
        x + side * normalX - point.x(),
        y + side * normalY - point.y(),
        z + side * normalZ - point.z(),
        1);
  }
}
