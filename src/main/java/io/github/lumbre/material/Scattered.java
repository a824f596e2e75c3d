package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;

/** A color of scattered light, and the density of its direction. Mutable. */
abstract class Scattered {
  double r, g, b;
  double pdf;

  /** The density of BSDF sampling alone. */
  double bsdfPdf;

  /** Sets the color and both densities. */
  final void set(double newR, double newG, double newB, double newPdf) {
    r = newR;
    g = newG;
    b = newB;
    pdf = newPdf;
    bsdfPdf = newPdf;
  }

  final Rgb color() {
    return new Rgb(r, g, b);
  }

  /** Returns the red component of the value or weight. */
  public final double r() {
    return r;
  }

  /** Returns the green component of the value or weight. */
  public final double g() {
    return g;
  }

  /** Returns the blue component of the value or weight. */
  public final double b() {
    return b;
  }

  /** Returns the density with which BSDF sampling alone draws the direction. */
  public final double bsdfPdf() {
    return bsdfPdf;
  }
}
