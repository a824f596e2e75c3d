package io.github.lumbre.material.internal;

import io.github.lumbre.material.Channel;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.SurfacePoint;
import java.util.Objects;

/** A number that varies over a surface, and may depend on any vertex attribute. Immutable. */
@FunctionalInterface
public interface ScalarChannel extends Channel {
  double at(SurfacePoint point);

  /** Returns the value at a point of a surface, clamped to [0,1]; NaN becomes 0. */
  default double fractionAt(SurfacePoint point) {
    double value = at(point);
    return value > 0 ? Math.min(1, value) : 0;
  }

  /** Returns a channel with the same value everywhere. */
  static ScalarChannel of(double value) {
    return of(ScalarTexture.constant(value), 0);
  }

  /**
   * Returns the channel of a texture.
   *
   * @param uvSet 0 or 1: the set of texture coordinates
   */
  static ScalarChannel of(ScalarTexture texture, int uvSet) {
    return new Textured(texture, uvSet);
  }

  /**
   * The channel of a texture.
   *
   * @param uvSet 0 or 1: the set of texture coordinates
   */
  record Textured(ScalarTexture texture, int uvSet) implements ScalarChannel {
    public Textured {
      Objects.requireNonNull(texture, "texture");
    }

    @Override
    public double at(SurfacePoint point) {
      return texture.at(point.u(uvSet), point.v(uvSet));
    }

    @Override
    public boolean isConstant() {
      return texture.isConstant();
    }
  }
}
