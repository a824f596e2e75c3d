package io.github.lumbre.material;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.texture.TexturePoint;

/** A surface material: evaluates its textures at a hit and returns the BSDF there. Immutable. */
public interface Material {
  /**
   * Returns the BSDF at a point of the surface, in the hit's shading frame.
   *
   * @param u texture coordinate, any finite number
   * @param v texture coordinate, any finite number
   */
  Bsdf at(double u, double v);

  /** Returns the BSDF at a point of the surface, in the hit's shading frame. */
  default Bsdf at(TexturePoint point) {
    return at(point.u(), point.v());
  }

  /**
   * Returns whether the BSDF is known to be the same at all points of the surface, in the shading
   * frame.
   */
  boolean isUniform();

  /** Returns an equivalent material that evaluates constant textures only once. */
  default Material simplified() {
    return isUniform() ? new UniformMaterial(at(0, 0)) : this;
  }

  /** Perturbs the hit's shading frame by a normal map, if there is one. */
  default void bend(SurfaceHit hit) {}
}
