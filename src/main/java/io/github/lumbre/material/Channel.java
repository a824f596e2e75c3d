package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.ColorChannel;
import io.github.lumbre.material.internal.NormalChannel;
import io.github.lumbre.material.internal.ScalarChannel;
import io.github.lumbre.texture.NormalMap;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;

/**
 * A value of a {@link MetallicRoughness} material that varies over a surface. The set of texture
 * coordinates that it reads is 0 or 1. Immutable.
 */
public interface Channel {
  /** Returns the channel of a color. */
  static Channel color(Texture<Rgb> texture, int uvSet) {
    return ColorChannel.of(texture, uvSet);
  }

  /** Returns the channel of a number. */
  static Channel number(ScalarTexture texture, int uvSet) {
    return ScalarChannel.of(texture, uvSet);
  }

  /** Returns the channel of a normal map. */
  static Channel normals(NormalMap map, int uvSet) {
    return new NormalChannel(map, uvSet);
  }

  /** Returns whether the value is known to be the same everywhere. */
  default boolean isConstant() {
    return false;
  }
}
