package io.github.lumbre.texture;

/** A value at each point of a surface, in practice a colour. */
@FunctionalInterface
public interface Texture<T> {
  T at(TexturePoint p);

  /** Tells whether the texture is known to have one value everywhere. */
  default boolean isConstant() {
    return false;
  }

  /** Returns the texture that has one value everywhere. */
  static <T> Texture<T> constant(T value) {
    return new Constant<>(value);
  }
}
