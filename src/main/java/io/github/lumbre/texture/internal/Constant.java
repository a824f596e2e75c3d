package io.github.lumbre.texture.internal;

import io.github.lumbre.texture.Texture;
import java.util.Objects;

/** A texture with the same value everywhere. */
public record Constant<T>(T value) implements Texture<T> {
  public Constant {
    Objects.requireNonNull(value, "value");
  }

  @Override
  public boolean isConstant() {
    return true;
  }

  @Override
  public T at(double u, double v) {
    return value;
  }
}
