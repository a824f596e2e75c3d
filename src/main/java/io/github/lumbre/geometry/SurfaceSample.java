package io.github.lumbre.geometry;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.TexturePoint;

/**
 * A point drawn from a shape's surface, or none if nothing of the shape can be seen. Mutable: each
 * thread fills one and the same again and again.
 */
public final class SurfaceSample {
  private double referenceX, referenceY, referenceZ;
  private double randomX, randomY;
  private double x, y, z;
  private double normalX, normalY, normalZ = 1;
  private double u, v;
  private double error;
  private double pdf;

  /** Makes a sample of nothing. */
  public SurfaceSample() {}

  /**
   * Asks for a point that a reference may see.
   *
   * @param fromX of the reference, in world space
   * @param u uniform in [0,1)²: chooses the point
   */
  public void ask(double fromX, double fromY, double fromZ, Point2 u) {
    referenceX = fromX;
    referenceY = fromY;
    referenceZ = fromZ;
    randomX = u.x();
    randomY = u.y();
  }

  /** Returns the point, in world space, that is to see what is drawn. */
  public Vec3 reference() {
    return new Vec3(referenceX, referenceY, referenceZ);
  }

  /** Returns the uniform point of [0,1)² that chooses what is drawn. */
  public Point2 random() {
    return new Point2(randomX, randomY);
  }

  /** Says that nothing can be seen. */
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
