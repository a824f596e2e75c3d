package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;

/**
 * The value of a {@link Bsdf} for a pair of directions, and the density with which it samples the
 * second. Mutable: each thread reuses one instance, so that the path loop allocates nothing.
 */
public final class BsdfValue extends Scattered {
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

  /** Sets the density to a mixture of BSDF sampling and another technique. */
  public void mix(double newPdf) {
    pdf = newPdf;
  }

  /** Multiplies the densities by the probability of the next choice. */
  public void scalePdf(double factor) {
    pdf *= factor;
    bsdfPdf *= factor;
  }

  /** Returns f·|cos θi|. */
  public Rgb f() {
    return color();
  }

  /** Returns the density per solid angle with which wi would be sampled. */
  public double pdf() {
    return pdf;
  }
}
