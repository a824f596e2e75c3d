package io.github.lumbre.material;

/** A surface that scatters nothing: that of a light, or one that shows its own color only. */
public enum Unlit implements Material {
  INSTANCE;

  @Override
  public boolean isUniform() {
    return true;
  }

  @Override
  public Bsdf at(double u, double v) {
    return Absorber.BLACK;
  }
}
