package io.github.lumbre.integrator.guiding;

/**
 * A direction sampled from a {@link Guide}. Mutable: each thread reuses one instance, so that the
 * path loop allocates nothing.
 */
public final class GuideSample {
  private double x, y, z;
  private double pdf;

  /** Creates a sample without a direction. */
  public GuideSample() {}

  void setDirection(double newX, double newY, double newZ) {
    x = newX;
    y = newY;
    z = newZ;
  }

  void setPdf(double newPdf) {
    pdf = newPdf;
  }

  /** Returns the x coordinate of the unit direction, in world space. */
  public double x() {
    return x;
  }

  /** Returns the y coordinate of the unit direction, in world space. */
  public double y() {
    return y;
  }

  /** Returns the z coordinate of the unit direction, in world space. */
  public double z() {
    return z;
  }

  /** Returns the density per solid angle. */
  public double pdf() {
    return pdf;
  }
}
