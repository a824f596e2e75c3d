package io.github.lumbre.material;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.texture.ScalarTexture;
import java.util.Objects;

/** A number that varies over a surface, and may depend on any vertex attribute. Immutable. */
@FunctionalInterface
public interface ScalarChannel {
  /** Returns the value at a hit. */
  double at(SurfaceHit hit);

  /** Returns whether the value is known to be the same everywhere. */
  default boolean isConstant() {
    return false;
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
    public double at(SurfaceHit hit) {
      return texture.at(hit.u(uvSet), hit.v(uvSet));
    }

    @Override
    public boolean isConstant() {
      return texture.isConstant();
    }
  }
}
