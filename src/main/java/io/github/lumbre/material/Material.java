package io.github.lumbre.material;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.math.Frame;

/** What a surface is made of: reads its textures at a hit. Immutable. */
public interface Material {
  /** Returns how the surface scatters at the hit, in the frame of {@link #frame}. */
  Bsdf at(SurfaceHit hit);

  /** Returns the frame the Bsdf works in; a normal map bends it. */
  default Frame frame(SurfaceHit hit) {
    return hit.shading();
  }
}
