package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;

/**
 * The value of a {@link Bsdf} for a pair of directions, and the density with which it samples the
 * second. Mutable: each thread reuses one instance, so that the path loop allocates nothing.
 */
public final class BsdfValue {
  private double r, g, b;
  private double pdf;

  /** The density of BSDF sampling alone. */
  private double bsdfPdf;

  /** Creates a value of 0: no light scatters. */
  public BsdfValue() {}

  /** Sets the value and the density to 0. */
  public void clear() {
    set(0, 0, 0, 0);
  }

  /**
   * Sets the value and the density.
   *
   * @param f f·|cos θi|, without delta lobes
   * @param newPdf density per solid angle with which wi would be sampled, without delta lobes
   */
  public void set(Rgb f, double newPdf) {
    set(f.r(), f.g(), f.b(), newPdf);
  }

  /** Sets the value, given by its components, and the density. */
  void set(double newR, double newG, double newB, double newPdf) {
    r = newR;
    g = newG;
    b = newB;
    pdf = newPdf;
    bsdfPdf = newPdf;
  }

  /** Sets the density to a mixture of BSDF sampling and another technique. */
  public void mix(double newPdf) {
    pdf = newPdf;
  }

  /** Multiplies the densities by the probability of the next choice. */
  public void scalePdf(double factor) {
    pdf *= factor;
    bsdfPdf *= factor;
  }

  /** Returns the red component of {@link #f}. */
  public double r() {
    return r;
  }

  /** Returns the green component of {@link #f}. */
  public double g() {
    return g;
  }

  /** Returns the blue component of {@link #f}. */
  public double b() {
    return b;
  }

  /** Returns f·|cos θi|. */
  public Rgb f() {
    return new Rgb(r, g, b);
  }

  /** Returns the density per solid angle with which wi would be sampled. */
  public double pdf() {
    return pdf;
  }

  /** Returns the density with which BSDF sampling alone draws the direction; see {@link #mix}. */
  public double bsdfPdf() {
    return bsdfPdf;
  }
}
