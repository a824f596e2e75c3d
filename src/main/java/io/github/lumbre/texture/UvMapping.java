package io.github.lumbre.texture;

import io.github.lumbre.texture.internal.MappedTexture;
import java.util.Objects;

/**
 * A mapping from a surface's (u, v) to texture coordinates: (u · scaleX + offsetX, v · scaleY +
 * offsetY). All numbers are finite.
 */
public record UvMapping(double offsetX, double offsetY, double scaleX, double scaleY) {
  /** The identity mapping. */
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

  /** Returns the texture coordinates of a surface's (u, v). */
  public TexturePoint apply(TexturePoint p) {
    return new TexturePoint(u(p.u()), v(p.v()));
  }

  /** Returns the texture coordinate of a surface's u. */
  public double u(double u) {
    return u * scaleX + offsetX;
  }

  /** Returns the texture coordinate of a surface's v. */
  public double v(double v) {
    return v * scaleY + offsetY;
  }

  /** Returns the texture with this mapping applied to its coordinates. */
  public <T> Texture<T> over(Texture<T> texture) {
    Objects.requireNonNull(texture, "texture");
    return equals(IDENTITY) ? texture : new MappedTexture<>(this, texture);
  }

  /** Returns the mapping that repeats a texture so many times over u and v from 0 to 1. */
  public static UvMapping repeating(double timesU, double timesV) {
    return new UvMapping(0, 0, timesU, timesV);
  }

  private static void requireFinite(double value, String name) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(name + ": expected a finite number, found " + value);
    }
  }
}
