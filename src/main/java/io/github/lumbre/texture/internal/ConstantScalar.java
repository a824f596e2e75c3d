package io.github.lumbre.texture.internal;

import io.github.lumbre.texture.ScalarTexture;

/** A scalar texture with the same value everywhere. */
public record ConstantScalar(double value) implements ScalarTexture {
  @Override
  public double at(double u, double v) {
    return value;
  }

  @Override
  public boolean isConstant() {
    return true;
  }
}
