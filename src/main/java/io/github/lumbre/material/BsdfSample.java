package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;

/**
 * A direction sampled from a {@link Bsdf}, with its weight and density; absorbed if there is none.
 * Mutable: each thread reuses one instance, so that the path loop allocates nothing.
 */
public final class BsdfSample {
  private double x, y, z = 1;
  private double r, g, b;
  private double pdf;

  /** Memory for what is scattered into the direction. */
  private final BsdfValue value = new BsdfValue();

  /** Creates a sample of absorbed light. */
  public BsdfSample() {}

  /** Sets the sample to absorbed: the light ends here. */
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

  /**
   * Sets weight and density by the BSDF's value for the direction; absorbs it if that is 0.
   *
   * @param wo direction to the viewer: local, of unit length
   */
  void weighBy(Bsdf bsdf, Vec3 wo) {
    bsdf.evaluate(wo.x(), wo.y(), wo.z(), x, y, z, value);
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

  /** Returns the unit direction; undefined if the sample is absorbed. */
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
