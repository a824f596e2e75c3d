package io.github.lumbre.texture.internal;

import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.UvMapping;

/** A texture whose coordinates are mapped. */
public record MappedTexture<T>(UvMapping mapping, Texture<T> texture) implements Texture<T> {
  @Override
  public T at(double u, double v) {
    return texture.at(mapping.u(u), mapping.v(v));
  }
}
