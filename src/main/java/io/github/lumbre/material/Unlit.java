package io.github.lumbre.material;

/** A surface that scatters nothing: of a lamp, or of anything that shows its own colour only. */
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
