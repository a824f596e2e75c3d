package io.github.lumbre.texture;

import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.internal.Constant;
import io.github.lumbre.texture.internal.ImageTexture;

/**
 * A value that varies over a surface, usually a color.
 *
 * @param <T> the type of the values
 */
@FunctionalInterface
public interface Texture<T> {
  /**
   * Returns the value at (u, v), which may be any finite numbers. Plain numbers avoid the
   * allocation of a point.
   */
  T at(double u, double v);

  /** Returns the value at a point, by its first texture coordinates unless stated. */
  default T at(SurfacePoint p) {
    return at(p.u(0), p.v(0));
  }

  /** Returns whether the texture is known to have the same value everywhere. */
  default boolean isConstant() {
    return false;
  }

  /** Returns a texture with the same value everywhere. */
  static <T> Texture<T> constant(T value) {
    return new Constant<>(value);
  }

  /**
   * Returns a picture in sRGB as a texture that repeats, interpolated between its texels. u = 0 is
   * its left edge and v = 0 its lower edge.
   */
  static Texture<Rgb> image(Pixels picture) {
    return new ImageTexture(picture, ImageTexture.Role.COLOR, ImageTexture.Filter.BILINEAR);
  }
}
