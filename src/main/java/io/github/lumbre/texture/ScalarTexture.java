package io.github.lumbre.texture;

/** A number at each point of a surface: a roughness, an exponent, an index of refraction. */
@FunctionalInterface
public interface ScalarTexture {
  /** Returns the value at any finite (u, v). */
  double at(double u, double v);

  /** Returns the value at a point. */
  default double at(TexturePoint p) {
    return at(p.u(), p.v());
  }

  /** Tells whether the texture is known to have one value everywhere. */
  default boolean isConstant() {
    return false;
  }

  /** Returns the texture that has one value everywhere. */
  static ScalarTexture constant(double value) {
    return new ConstantScalar(value);
  }
}
