package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;

/**
 * What a {@link Bsdf} says of a pair of directions, and the pair. Mutable, in plain numbers: each
 * thread fills one and the same again and again, and no object is made for a question or its
 * answer.
 */
public final class BsdfValue {
  private double outX, outY, outZ = 1;
  private double inX, inY, inZ = 1;
  private double r, g, b;
  private double pdf;

  /** Makes the value of nothing scattered. */
  public BsdfValue() {}

  /**
   * Asks for two directions, local and of unit length.
   *
   * @param woX of the one to the viewer
   * @param wiX of the one to the light
   */
  public void ask(double woX, double woY, double woZ, double wiX, double wiY, double wiZ) {
    outX = woX;
    outY = woY;
    outZ = woZ;
    inX = wiX;
    inY = wiY;
    inZ = wiZ;
  }

  /** Returns the direction to the viewer, local and of unit length. */
  public Vec3 wo() {
    return new Vec3(outX, outY, outZ);
  }

  /** Returns the direction to the light, local and of unit length. */
  public Vec3 wi() {
    return new Vec3(inX, inY, inZ);
  }

  /** Returns the z of {@link #wo}. */
  double cosine() {
    return outZ;
  }

  /** Says that nothing is scattered that way. */
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
