package io.github.lumbre.texture;

import java.util.Objects;

/**
 * Where in a texture a surface's (u, v) is read: at (u · scaleX + offsetX, v · scaleY + offsetY).
 */
public record UvMapping(double offsetX, double offsetY, double scaleX, double scaleY) {
  /** Reads every texture where the surface says. */
  public static final UvMapping IDENTITY = new UvMapping(0, 0, 1, 1);

  /**
   * @throws IllegalArgumentException if a number is not finite
   */
  public UvMapping {
    requireFinite(offsetX, "offsetX");
    requireFinite(offsetY, "offsetY");
    requireFinite(scaleX, "scaleX");
    requireFinite(scaleY, "scaleY");
  }

  /** Returns where a point of the surface lies in the texture. */
  public TexturePoint apply(TexturePoint p) {
    return new TexturePoint(u(p.u()), v(p.v()));
  }

  /** Returns the texture's u of the surface's. */
  double u(double u) {
    return u * scaleX + offsetX;
  }

  /** Returns the texture's v of the surface's. */
  double v(double v) {
    return v * scaleY + offsetY;
  }

  /** Returns the texture, read through this mapping. */
  public <T> Texture<T> over(Texture<T> texture) {
    Objects.requireNonNull(texture, "texture");
    return equals(IDENTITY) ? texture : (u, v) -> texture.at(u(u), v(v));
  }

  private static void requireFinite(double value, String name) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(name + ": expected a finite number, found " + value);
    }
  }
}
