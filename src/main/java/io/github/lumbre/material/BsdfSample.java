package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;

/**
 * A direction drawn from a {@link Bsdf}, or none if the light ends there; and what it is drawn for.
 * Mutable, in plain numbers: each thread fills one and the same again and again, and no object is
 * made for a question or its answer.
 */
public final class BsdfSample {
  private double outX, outY, outZ = 1;
  private double uLobe;
  private double u, v;
  private double x, y, z = 1;
  private double r, g, b;
  private double pdf;

  /** Memory for what is scattered into the direction. */
  private final BsdfValue value = new BsdfValue();

  /** Makes a sample in which the light ends. */
  public BsdfSample() {}

  /**
   * Asks for a direction.
   *
   * @param woX of the direction to the viewer: local, of unit length
   * @param newULobe uniform in [0,1): chooses among lobes, if {@link Bsdf#choosesLobe} says so
   * @param newU uniform in [0,1)²
   */
  public void ask(double woX, double woY, double woZ, double newULobe, Point2 newU) {
    outX = woX;
    outY = woY;
    outZ = woZ;
    uLobe = newULobe;
    u = newU.x();
    v = newU.y();
  }

  /** Returns the direction to the viewer, local and of unit length. */
  public Vec3 wo() {
    return new Vec3(outX, outY, outZ);
  }

  /** Returns the z of {@link #wo}. */
  double cosine() {
    return outZ;
  }

  /** Returns the uniform number in [0,1) that chooses among lobes. */
  public double uLobe() {
    return uLobe;
  }

  /** Returns the uniform point of [0,1)² that chooses the direction. */
  public Point2 random() {
    return new Point2(u, v);
  }

  /** Says that the light ends here. */
  public void absorb() {
    set(Vec3.Z, Rgb.BLACK, 0);
  }

  /**
   * Sets what was drawn.
   *
   * @param wi local, of unit length
   * @param weight f·|cos θi| / pdf, over all the lobes that could have drawn wi
   * @param newPdf per solid angle, delta lobes aside
   */
  public void set(Vec3 wi, Rgb weight, double newPdf) {
    setDirection(wi);
    r = weight.r();
    g = weight.g();
    b = weight.b();
    pdf = newPdf;
  }

  /** Sets a sample of a delta lobe. */
  public void setSpecular(Vec3 wi, Rgb weight) {
    set(wi, weight, Double.POSITIVE_INFINITY);
  }

  /** Sets weight and density by what is scattered into the direction; absorbs it if nothing is. */
  void weighBy(Bsdf bsdf) {
    value.ask(outX, outY, outZ, x, y, z);
    bsdf.evaluate(value);
    if (value.pdf() > 0 && value.pdf() < Double.POSITIVE_INFINITY) {
      set(wi(), value.f().times(1 / value.pdf()), value.pdf());
    } else {
      // So close to the horizon that the product of two cosines is 0.
      absorb();
    }
  }

  /** Sets the direction alone. */
  public void setDirection(Vec3 wi) {
    setDirection(wi.x(), wi.y(), wi.z());
  }

  /** Sets the direction alone, by its coordinates. */
  public void setDirection(double newX, double newY, double newZ) {
    x = newX;
    y = newY;
    z = newZ;
  }

  /** Returns the unit direction; of an absorbed sample, any. */
  public Vec3 wi() {
    return new Vec3(x, y, z);
  }

  /** Returns the x of {@link #wi}. */
  public double x() {
    return x;
  }

  /** Returns the y of {@link #wi}. */
  public double y() {
    return y;
  }

  /** Returns the z of {@link #wi}. */
  public double z() {
    return z;
  }

  /** Returns the red component of {@link #weight}. */
  public double r() {
    return r;
  }

  /** Returns the green component of {@link #weight}. */
  public double g() {
    return g;
  }

  /** Returns the blue component of {@link #weight}. */
  public double b() {
    return b;
  }

  /** Returns f·|cos θi| / pdf; black if the light ends here. */
  public Rgb weight() {
    return new Rgb(r, g, b);
  }

  /** Returns the density per solid angle; of a delta lobe, infinite; of no sample, 0. */
  public double pdf() {
    return pdf;
  }

  public boolean isAbsorbed() {
    return r == 0 && g == 0 && b == 0;
  }

  public boolean isSpecular() {
    return pdf == Double.POSITIVE_INFINITY;
  }
}
