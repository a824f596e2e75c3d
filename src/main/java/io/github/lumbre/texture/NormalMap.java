package io.github.lumbre.texture;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Frame;
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
   * Returns the frame around the bent normal. A normal below the true surface is bent back to just
   * above it.
   *
   * @param shading frame with tangents along growing u and v
   * @param geometricNormal of the true surface, of unit length, on the side of the shading normal
   */
  public Frame perturb(Frame shading, Vec3 geometricNormal, TexturePoint p) {
    Rgb n = normals.at(mapping.u(p.u()), mapping.v(p.v()));
    double x = n.r() * strength * Math.signum(mapping.scaleX());
    double y = n.g() * strength * Math.signum(mapping.scaleY());
    if (x == 0 && y == 0 && n.b() > 0) {
      return shading;
    }
    Vec3 local = new Vec3(x, y, n.b());
    if (local.maxAbs() == 0) {
      return shading;
    }
    // Normalize first, lest sums of huge components overflow.
    Vec3 normal = shading.toWorld(local.normalized()).normalized();
    double height = normal.dot(geometricNormal);
    if (height < LOWEST_COSINE) {
      normal = normal.plus(LOWEST_COSINE - height, geometricNormal);
      normal = normal.lengthSquared() < LOWEST_COSINE ? geometricNormal : normal.normalized();
    }
    return Frame.around(normal, shading.tangent(), shading.bitangent());
  }
}
