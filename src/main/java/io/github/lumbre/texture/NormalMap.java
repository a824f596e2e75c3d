package io.github.lumbre.texture;

import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.texture.internal.ImageTexture;
import java.util.Objects;

/**
 * Perturbs the normals of a surface with a texture in tangent space: red along increasing u, green
 * along increasing v, blue outward. Immutable.
 */
public final class NormalMap {
  /** The minimum cosine between a perturbed normal and the geometric normal. */
  private static final double LOWEST_COSINE = 1e-3;

  private final Texture<Rgb> normals;
  private final UvMapping mapping;
  private final double strength;

  /**
   * Creates a normal map.
   *
   * @param normals the texture of normals, with components in [-1,1] and any length, without the
   *     mapping
   * @param mapping the mapping of texture coordinates; a mirroring one also mirrors the bumps
   * @param strength the factor of the slopes, finite: 0 is flat, 1 is the unchanged map
   * @throws IllegalArgumentException if the strength is not finite
   */
  public NormalMap(Texture<Rgb> normals, UvMapping mapping, double strength) {
    this.normals = Objects.requireNonNull(normals, "normals");
    this.mapping = Objects.requireNonNull(mapping, "mapping");
    this.strength = Range.ANY.require("strength", strength);
  }

  /** Creates a normal map without a mapping. */
  public NormalMap(Texture<Rgb> normals, double strength) {
    this(normals, UvMapping.IDENTITY, strength);
  }

  /** Returns the unchanged map of a picture that stores normals. */
  public static NormalMap of(Pixels picture) {
    return new NormalMap(
        new ImageTexture(picture, ImageTexture.Role.NORMAL, ImageTexture.Filter.BILINEAR), 1);
  }

  /** Returns the texture of normals, without the mapping. */
  public Texture<Rgb> normals() {
    return normals;
  }

  /** Returns the mapping of texture coordinates. */
  public UvMapping mapping() {
    return mapping;
  }

  /** Returns the factor of the slopes. */
  public double strength() {
    return strength;
  }

  /** Returns the map's stored value at a point of the texture, without mapping and strength. */
  public Rgb value(TexturePoint p) {
    return normals.at(p);
  }

  /**
   * Returns the perturbed normal in the shading frame of the surface: along increasing u,
   * increasing v and outward. It can have any length. The result is zero where the surface keeps
   * its normal.
   *
   * @param u the surface's u, before the mapping
   * @param v the surface's v, before the mapping
   */
  public Vec3 normal(double u, double v) {
    Rgb n = normals.at(mapping.u(u), mapping.v(v));
    double x = n.r() * strength * Math.signum(mapping.scaleX());
    double y = n.g() * strength * Math.signum(mapping.scaleY());
    boolean isFlat = x == 0 && y == 0 && n.b() > 0;
    return new Vec3(x, y, isFlat ? 0 : n.b());
  }

  /**
   * Returns a perturbed normal. If it points below the true surface, it is raised to just above it.
   *
   * @param normal the perturbed unit normal, in world space
   * @param geometricNormal the unit normal of the true surface, in world space, on the side of the
   *     normal before the perturbation
   */
  public static Vec3 raised(Vec3 normal, Vec3 geometricNormal) {
    double x = normal.x();
    double y = normal.y();
    double z = normal.z();
    double height = normal.dot(geometricNormal);
    // Single allocation site, so that escape analysis can remove it.
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
