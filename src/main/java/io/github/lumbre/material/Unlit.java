package io.github.lumbre.material;

/**
 * The material of a surface that scatters no light: an area light, or a surface that shows only its
 * own color.
 */
public enum Unlit implements Material {
  /** The only value. */
  INSTANCE;

  @Override
  public boolean isUniform() {
    return true;
  }

  @Override
  public Bsdf at(double u, double v) {
    return Absorber.BLACK;
  }

  /** Returns this material, by which a surface is known not to scatter. */
  @Override
  public Material simplified() {
    return this;
  }
}
