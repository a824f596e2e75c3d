package io.github.lumbre.model.internal;

import java.util.Arrays;

/**
 * An affine map of texture coordinates: u' = uu·u + uv·v + u0, v' = vu·u + vv·v + v0, with v = 0 at
 * the lower edge of the picture.
 */
public record UvTransform(double uu, double uv, double u0, double vu, double vv, double v0) {

  public static final UvTransform IDENTITY = new UvTransform(1, 0, 0, 0, 1, 0);

  /** Returns whether coordinates stay as they are. */
  boolean isIdentity() {
    return uu == 1 && uv == 0 && u0 == 0 && vu == 0 && vv == 1 && v0 == 0;
  }

  // Java would make the code of the next two at the first call, which delays each start.

  @Override
  public boolean equals(Object other) {
    return other instanceof UvTransform map && Arrays.equals(numbers(), map.numbers());
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(numbers());
  }

  private double[] numbers() {
    return new double[] {uu, uv, u0, vu, vv, v0};
  }

  /** Returns the mapped u. */
  public double u(double u, double v) {
    return uu * u + uv * v + u0;
  }

  /** Returns the mapped v. */
  public double v(double u, double v) {
    return vu * u + vv * v + v0;
  }
}
