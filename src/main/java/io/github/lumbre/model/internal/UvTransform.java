package io.github.lumbre.model.internal;

/**
 * An affine map of texture coordinates: u' = uu·u + uv·v + u0, v' = vu·u + vv·v + v0, with v = 0 at
 * the lower edge of the picture.
 */
public record UvTransform(double uu, double uv, double u0, double vu, double vv, double v0) {

  public static final UvTransform IDENTITY = new UvTransform(1, 0, 0, 0, 1, 0);

  /** Returns the mapped u. */
  public double u(double u, double v) {
    return uu * u + uv * v + u0;
  }

  /** Returns the mapped v. */
  public double v(double u, double v) {
    return vu * u + vv * v + v0;
  }
}
