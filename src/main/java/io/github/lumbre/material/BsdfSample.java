package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;

/**
 * A direction sampled from a {@link Bsdf}, with its weight and density, or an absorbed sample
 * without a direction. Mutable: each thread reuses one instance, so that the path loop allocates
 * nothing.
 */
public final class BsdfSample extends Scattered {
  private double x, y, z = 1;

  /** Receives the value of the BSDF in {@link #weighBy}. */
  private final BsdfValue value = new BsdfValue();

  /** Creates an absorbed sample. */
  public BsdfSample() {}

  /** Sets the sample to absorbed: no light scatters. */
  public void absorb() {
    set(Vec3.Z, Rgb.BLACK, 0);
  }

  /**
   * Sets the direction, its weight and its density.
   *
   * @param wi unit direction in the local frame
   * @param weight f·|cos θi| / pdf, summed over all lobes that could have drawn wi
   * @param newPdf density per solid angle, without delta lobes
   */
  public void set(Vec3 wi, Rgb weight, double newPdf) {
    setDirection(wi);
    set(weight.r(), weight.g(), weight.b(), newPdf);
  }

  /**
   * Sets a direction that a mixture of BSDF sampling and another technique has drawn.
   *
   * @param wi unit direction in world space
   * @param weight f·|cos θi| / pdf
   * @param newPdf density of the mixture per solid angle
   * @param newBsdfPdf density of BSDF sampling alone
   */
  public void setMixed(Vec3 wi, Rgb weight, double newPdf, double newBsdfPdf) {
    set(wi, weight, newPdf);
    bsdfPdf = newBsdfPdf;
  }

  /**
   * Sets the density to a mixture of densities, and the weight accordingly.
   *
   * @param newPdf density per solid angle, above 0
   */
  public void mix(double newPdf) {
    scale(pdf / newPdf);
    pdf = newPdf;
  }

  /** Multiplies the weight by a factor. */
  public void scale(double factor) {
    r *= factor;
    g *= factor;
    b *= factor;
  }

  /** Sets a sample of a delta lobe, whose density is infinite. */
  public void setSpecular(Vec3 wi, Rgb weight) {
    set(wi, weight, Double.POSITIVE_INFINITY);
  }

  /**
   * Evaluates a BSDF for the current direction and sets the weight and density from it; absorbs the
   * sample if the density is 0.
   *
   * @param wo direction to the viewer: local, of unit length
   */
  public void weighBy(Bsdf bsdf, Vec3 wo) {
    bsdf.evaluate(wo.x(), wo.y(), wo.z(), x, y, z, value);
    if (value.pdf() > 0 && value.pdf() < Double.POSITIVE_INFINITY) {
      set(wi(), value.f().times(1 / value.pdf()), value.pdf());
    } else {
      // The direction is so close to the horizon that the product of two cosines underflows to 0.
      absorb();
    }
  }

  /** Sets only the direction, a unit vector. */
  public void setDirection(Vec3 wi) {
    setDirection(wi.x(), wi.y(), wi.z());
  }

  /** Sets only the direction, given by its coordinates. */
  public void setDirection(double newX, double newY, double newZ) {
    x = newX;
    y = newY;
    z = newZ;
  }

  /** Returns the unit direction; undefined if the sample is absorbed. */
  public Vec3 wi() {
    return new Vec3(x, y, z);
  }

  /** Returns the x coordinate of {@link #wi}. */
  public double x() {
    return x;
  }

  /** Returns the y coordinate of {@link #wi}. */
  public double y() {
    return y;
  }

  /** Returns the z coordinate of {@link #wi}. */
  public double z() {
    return z;
  }

  /** Returns f·|cos θi| / pdf; black if the sample is absorbed. */
  public Rgb weight() {
    return color();
  }

  /**
   * Returns the density per solid angle: infinite for a delta lobe, 0 if the sample is absorbed.
   */
  public double pdf() {
    return pdf;
  }

  /** Returns whether no light is scattered: the weight is black. */
  public boolean isAbsorbed() {
    return r == 0 && g == 0 && b == 0;
  }

  /** Returns whether the direction is the only one that its lobe scatters to. */
  public boolean isSpecular() {
    return pdf == Double.POSITIVE_INFINITY;
  }
}
