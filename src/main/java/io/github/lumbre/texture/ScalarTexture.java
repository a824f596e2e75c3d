package io.github.lumbre.texture;

/** A number at each point of a surface: a roughness, an exponent, an index of refraction. */
@FunctionalInterface
public interface ScalarTexture {
  double at(TexturePoint p);

  /** Tells whether the texture is known to have one value everywhere. */
  default boolean isConstant() {
    return false;
  }

  /** Returns the texture that has one value everywhere. */
  static ScalarTexture constant(double value) {
    return new ConstantScalar(value);
  }
}
