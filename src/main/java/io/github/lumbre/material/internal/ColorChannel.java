package io.github.lumbre.material.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Channel;
import io.github.lumbre.texture.SurfacePoint;
import io.github.lumbre.texture.Texture;
import java.util.Objects;

/** A color that varies over a surface, and may depend on any vertex attribute. Immutable. */
@FunctionalInterface
public interface ColorChannel extends Channel {
  /** Returns the linear color at a point of a surface; each component is at least 0. */
  Rgb at(SurfacePoint point);

  /** Returns a channel with the same color everywhere. */
  static ColorChannel of(Rgb color) {
    return of(Texture.constant(color), 0);
  }

  /**
   * Returns the channel of a texture.
   *
   * @param uvSet 0 or 1: the set of texture coordinates
   */
  static ColorChannel of(Texture<Rgb> texture, int uvSet) {
    return new Textured(texture, uvSet);
  }

  /**
   * The channel of a texture.
   *
   * @param uvSet 0 or 1: the set of texture coordinates
   */
  record Textured(Texture<Rgb> texture, int uvSet) implements ColorChannel {
    public Textured {
      Objects.requireNonNull(texture, "texture");
    }

    @Override
    public Rgb at(SurfacePoint point) {
      return texture.at(point.u(uvSet), point.v(uvSet));
    }

    @Override
    public boolean isConstant() {
      return texture.isConstant();
    }
  }
}
