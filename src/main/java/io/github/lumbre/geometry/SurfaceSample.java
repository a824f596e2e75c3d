package io.github.lumbre.geometry;

import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.TexturePoint;

/**
 * A point drawn from a shape's surface, or none if nothing of the shape can be seen. Mutable: each
 * thread reuses one instance.
 */
public final class SurfaceSample {
  private double x, y, z;
  private double normalX, normalY, normalZ = 1;
  private double u, v;
  private double error;
  private double pdf;

  /** Makes a sample of nothing. */
  public SurfaceSample() {}

  /** Sets the sample to none: nothing of the shape is visible. */
  public void clear() {
    pdf = 0;
  }

  /**
   * Sets what was drawn.
   *
   * @param position on the surface, in world space
   * @param normal the geometric normal there, outward, of unit length
   * @param texture the texture coordinates there
   * @param newError bound of the position's distance from the true surface along the normal
   * @param newPdf the point's density per solid angle at the reference, &gt; 0
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
  }

  /** Returns the point of the surface; of no sample, any. */
  public Vec3 position() {
    return new Vec3(x, y, z);
  }

  /** Returns the geometric normal there, outward, of unit length. */
  public Vec3 normal() {
    return new Vec3(normalX, normalY, normalZ);
  }

  /** Tells whether a point lies on the side that the normal points to. */
  public boolean isSeenFrontally(Vec3 from) {
    return (from.x() - x) * normalX + (from.y() - y) * normalY + (from.z() - z) * normalZ > 0;
  }

  /** Returns the texture coordinates there. */
  public TexturePoint texture() {
    return new TexturePoint(u, v);
  }

  /** Returns a bound of the position's distance from the true surface along the normal. */
  public double error() {
    return error;
  }

  /** Returns the point's density per solid angle at the reference; 0 means there is no sample. */
  public double pdf() {
    return pdf;
  }
}
