package io.github.lumbre.texture;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;
import java.util.Objects;

/**
 * Bends the normals of a surface by a texture in tangent space: red along growing u, green along
 * growing v, blue outward. Immutable.
 */
public final class NormalMap {
  /** Bent normals rise at least so far above the true surface. */
  private static final double LOWEST_COSINE = 1e-3;

  private final Texture<Rgb> normals;
  private final UvMapping mapping;
  private final double strength;

  /**
   * @param normals components in [-1,1], not necessarily of unit length, before the mapping
   * @param mapping where the map is read; a mirroring one mirrors the bumps
   * @param strength factor on the slopes: 0 is flat, 1 the map as it is
   */
  public NormalMap(Texture<Rgb> normals, UvMapping mapping, double strength) {
    this.normals = Objects.requireNonNull(normals, "normals");
    this.mapping = Objects.requireNonNull(mapping, "mapping");
    if (!Double.isFinite(strength)) {
      throw new IllegalArgumentException("strength: expected a finite number, found " + strength);
    }
    this.strength = strength;
  }

  /** Returns the map's own value at a point of the texture, before mapping and strength. */
  public Rgb value(TexturePoint p) {
    return normals.at(p);
  }

  /**
   * Returns the bent normal in the frame of the surface, along growing u, growing v and outward; of
   * any length, and zero where the surface keeps its own.
   *
   * @param u of the surface, before the mapping
   * @param v likewise
   */
  public Vec3 normal(double u, double v) {
    Rgb n = normals.at(mapping.u(u), mapping.v(v));
    double x = n.r() * strength * Math.signum(mapping.scaleX());
    double y = n.g() * strength * Math.signum(mapping.scaleY());
    boolean isFlat = x == 0 && y == 0 && n.b() > 0;
    return new Vec3(x, y, isFlat ? 0 : n.b());
  }

  /**
   * Returns a bent normal, but one below the true surface bent back to just above it.
   *
   * @param normal of unit length, in the world
   * @param geometricNormal of the true surface, of unit length, on the side of the normal that was
   *     bent
   */
  public static Vec3 raised(Vec3 normal, Vec3 geometricNormal) {
    double x = normal.x();
    double y = normal.y();
    double z = normal.z();
    double height = normal.dot(geometricNormal);
    // One place makes the result, so that the compiler need not make it at all.
    if (height < LOWEST_COSINE) {
      Vec3 sum = normal.plus(LOWEST_COSINE - height, geometricNormal);
      boolean isLost = sum.lengthSquared() < LOWEST_COSINE;
      Vec3 raised = sum.normalized();
      x = isLost ? geometricNormal.x() : raised.x();
      y = isLost ? geometricNormal.y() : raised.y();
      z = isLost ? geometricNormal.z() : raised.z();
    }
    return new Vec3(x, y, z);
  }
}
