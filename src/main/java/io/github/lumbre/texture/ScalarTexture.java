package io.github.lumbre.texture;

import io.github.lumbre.texture.internal.ConstantScalar;

/**
 * A number that varies over a surface, such as a roughness, an exponent or an index of refraction.
 */
@FunctionalInterface
public interface ScalarTexture {
  /** Returns the value at any finite (u, v). */
  double at(double u, double v);

  /** Returns the value at a point. */
  default double at(TexturePoint p) {
    return at(p.u(), p.v());
  }

  /** Returns whether the texture is known to have the same value everywhere. */
  default boolean isConstant() {
    return false;
  }

  /** Returns a texture with the same value everywhere. */
  static ScalarTexture constant(double value) {
    return new ConstantScalar(value);
  }
}
