package io.github.lumbre.texture;

/** A value at each point of a surface, in practice a colour. */
@FunctionalInterface
public interface Texture<T> {
  /** Returns the value at any finite (u, v): in plain numbers, so that asking makes no object. */
  T at(double u, double v);

  /** Returns the value at a point. */
  default T at(TexturePoint p) {
    return at(p.u(), p.v());
  }

  /** Tells whether the texture is known to have one value everywhere. */
  default boolean isConstant() {
    return false;
  }

  /** Returns the texture that has one value everywhere. */
  static <T> Texture<T> constant(T value) {
    return new Constant<>(value);
  }
}
