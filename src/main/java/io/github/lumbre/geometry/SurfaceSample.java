package io.github.lumbre.geometry;

import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.TexturePoint;

/**
 * A point drawn from a shape's surface.
 *
 * @param position on the surface, in world space
 * @param normal the geometric normal there, outward, of unit length
 * @param texture the texture coordinates there
 * @param error bound of the position's distance from the true surface along the normal
 * @param pdf the point's density per solid angle at the reference; 0 means there is no sample
 */
public record SurfaceSample(
    Vec3 position, Vec3 normal, TexturePoint texture, double error, double pdf) {
  /** No sample: nothing of the shape can be seen from the reference. */
  public static final SurfaceSample NONE =
      new SurfaceSample(Vec3.ZERO, Vec3.Z, new TexturePoint(0, 0), 0, 0);
}
