package io.github.lumbre.material;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.texture.TexturePoint;

/** What a surface is made of: reads its textures at a hit. Immutable. */
public interface Material {
  /**
   * Returns how the surface scatters at a point of it, in the hit's shading frame.
   *
   * @param u texture coordinate, any finite number
   * @param v texture coordinate, as u
   */
  Bsdf at(double u, double v);

  /** Returns how the surface scatters at a point of it, in the hit's shading frame. */
  default Bsdf at(TexturePoint point) {
    return at(point.u(), point.v());
  }

  /** Returns whether the surface is known to scatter everywhere alike, in its frame. */
  boolean isUniform();

  /** Returns a material that looks the same and does no work twice. */
  default Material simplified() {
    return isUniform() ? new UniformMaterial(at(0, 0)) : this;
  }

  /** Perturbs the hit's shading frame by a normal map, if there is one. */
  default void bend(SurfaceHit hit) {}
}
