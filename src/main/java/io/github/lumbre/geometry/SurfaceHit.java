package io.github.lumbre.geometry;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.TexturePoint;

/**
 * The surface where a ray hit it, in world space. The only home of the error bound that rays leave
 * a surface by.
 *
 * @param position on the surface, as exactly as the shape can say
 * @param geometricNormal the true normal, outward, of unit length, whichever side was hit
 * @param shading the normal to shade with (interpolated on smooth meshes, never more than 90° from
 *     the geometric one), and tangents along growing u and v
 * @param texture texture coordinates
 * @param wo unit direction back to where the ray came from
 * @param error bound of the position's distance from the true surface along the normal
 */
public record SurfaceHit(
    Vec3 position,
    Vec3 geometricNormal,
    Frame shading,
    TexturePoint texture,
    Vec3 wo,
    double error) {
  /** How far, relative to a ray's length, its meeting with a surface may be out of place. */
  private static final double ROUNDING = 16 * 0x1p-52;

  /** Returns the ray that leaves in a unit direction, on the side the direction points to. */
  public Ray spawn(Vec3 direction) {
    return new Ray(leave(direction), direction);
  }

  /** Returns the ray to a point, which is its end and excluded: t = 1 there. */
  public Ray spawnTowards(Vec3 point) {
    Vec3 origin = leave(point.minus(position));
    return new Ray(origin, point.minus(origin), 1);
  }

  /** Returns the ray to a point of another surface; it ends just before that surface. */
  public Ray spawnTowards(SurfaceSample sample) {
    Vec3 way = position.minus(sample.position());
    double margin = sample.error() + ROUNDING * way.maxAbs();
    double side = Math.copySign(margin, way.dot(sample.normal()));
    return spawnTowards(sample.position().plus(side, sample.normal()));
  }

  private Vec3 leave(Vec3 direction) {
    return position.plus(Math.copySign(error, direction.dot(geometricNormal)), geometricNormal);
  }
}
