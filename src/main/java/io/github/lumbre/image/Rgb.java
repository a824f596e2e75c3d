package io.github.lumbre.image;

/** A linear RGB color: a radiance, an irradiance, a reflectance or a weight. Immutable. */
public record Rgb(double r, double g, double b) {
  /** No light: all components are 0. */
  public static final Rgb BLACK = new Rgb(0, 0, 0);

  /** All components are 1. */
  public static final Rgb WHITE = new Rgb(1, 1, 1);

  /** Returns the color whose three components are the same. */
  public static Rgb gray(double v) {
    return new Rgb(v, v, v);
  }

  /** Returns the sum, component by component. */
  public Rgb plus(Rgb o) {
    return new Rgb(r + o.r, g + o.g, b + o.b);
  }

  /** Returns the product, component by component. */
  public Rgb times(Rgb o) {
    return new Rgb(r * o.r, g * o.g, b * o.b);
  }

  /** Returns the color with each component multiplied by a number. */
  public Rgb times(double s) {
    return new Rgb(r * s, g * s, b * s);
  }

  /** Returns the color with each component limited to at most 1. */
  public Rgb clampedToOne() {
    return r <= 1 && g <= 1 && b <= 1
        ? this
        : new Rgb(Math.min(r, 1), Math.min(g, 1), Math.min(b, 1));
  }

  /** Returns the relative luminance with the weights of ITU-R BT.709. */
  public double luminance() {
    return .2126 * r + .7152 * g + .0722 * b;
  }

  /** Returns the largest component. */
  public double max() {
    return Math.max(r, Math.max(g, b));
  }

  /** Returns whether all components are 0. */
  public boolean isBlack() {
    return r == 0 && g == 0 && b == 0;
  }

  // Java would make the code of the next two at the first call, which delays each start.

  @Override
  public boolean equals(Object other) {
    return other instanceof Rgb o
        && Double.compare(r, o.r) == 0
        && Double.compare(g, o.g) == 0
        && Double.compare(b, o.b) == 0;
  }

  @Override
  public int hashCode() {
    return (Double.hashCode(r) * 31 + Double.hashCode(g)) * 31 + Double.hashCode(b);
  }

  /** Returns whether all components are finite. */
  public boolean isFinite() {
    return Double.isFinite(r) && Double.isFinite(g) && Double.isFinite(b);
  }
}
