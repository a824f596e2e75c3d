package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;

/**
 * The value of a {@link Bsdf} for a pair of directions, and the density of sampling the second.
 * Mutable: each thread reuses one instance, so that the path loop allocates nothing.
 */
public final class BsdfValue {
  private double r, g, b;
  private double pdf;

  /** Creates the value of a pair between which nothing is scattered. */
  public BsdfValue() {}

  /** Sets both values to 0. */
  public void clear() {
    set(0, 0, 0, 0);
  }

  /**
   * Sets both values.
   *
   * @param f f·|cos θi|, delta lobes aside
   * @param newPdf density per solid angle with which wi would be drawn, delta lobes aside
   */
  public void set(Rgb f, double newPdf) {
    set(f.r(), f.g(), f.b(), newPdf);
  }

  /** Sets both values, the first by its components. */
  void set(double newR, double newG, double newB, double newPdf) {
    r = newR;
    g = newG;
    b = newB;
    pdf = newPdf;
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

  /** Returns the density per solid angle with which wi would be drawn. */
  public double pdf() {
    return pdf;
  }
}
