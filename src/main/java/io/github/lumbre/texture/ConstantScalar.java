package io.github.lumbre.texture;

/** The number that is the same everywhere. */
record ConstantScalar(double value) implements ScalarTexture {
  @Override
  public double at(double u, double v) {
    return value;
  }

  @Override
  public boolean isConstant() {
    return true;
  }
}
