package io.github.lumbre.texture;

import io.github.lumbre.image.Rgb;

/** What textures and vertex colors may depend on at a point of a surface. */
public interface SurfacePoint {
  /**
   * Returns the first texture coordinate of a set; of the first set if the surface has no second.
   *
   * @param set 0 or 1
   */
  double u(int set);

  /** Returns the second texture coordinate of a set; see {@link #u(int)}. */
  double v(int set);

  /** Returns the linear vertex color; white if the surface has none. */
  Rgb vertexColor();

  /** Returns the vertex alpha; 1 if the surface has none. */
  double vertexAlpha();
}
