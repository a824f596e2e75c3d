package io.github.lumbre.parser;

import io.github.lumbre.texture.ImageTexture.Filter;
import io.github.lumbre.texture.Texture;
import java.util.Optional;
import java.util.concurrent.atomic.LongAdder;

/**
 * A change of all textures of a scene, which overrides the file.
 *
 * @param forced filter instead of each texture's own
 * @param lookUps counts the values looked up in textures
 */
record TextureChange(Optional<Filter> forced, Optional<LongAdder> lookUps) {
  /** Takes textures as they are. */
  static final TextureChange NONE = new TextureChange(Optional.empty(), Optional.empty());

  TextureChange filtering(Filter filter) {
    return new TextureChange(Optional.of(filter), lookUps);
  }

  TextureChange counting(LongAdder adder) {
    return new TextureChange(forced, Optional.of(adder));
  }

  /** Returns the filter of a texture whose own is given. */
  Filter filter(Filter own) {
    return forced.orElse(own);
  }

  /** Returns the same texture, which is counted if that is wanted. */
  <T> Texture<T> watched(Texture<T> texture) {
    if (lookUps.isEmpty()) {
      return texture;
    }
    LongAdder adder = lookUps.get();
    return (u, v) -> {
      adder.increment();
      return texture.at(u, v);
    };
  }
}
