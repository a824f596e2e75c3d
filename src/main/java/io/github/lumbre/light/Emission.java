package io.github.lumbre.light;

import io.github.lumbre.geometry.SurfaceSample;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.SurfacePoint;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.TexturePoint;
import io.github.lumbre.texture.internal.Constant;
import java.util.Objects;

/**
 * The light that a surface emits.
 *
 * @param radiance emitted radiance in linear RGB, the same in all directions
 * @param twoSided whether the inside emits as well as the outside
 * @param meanRadiance estimate of the mean radiance over the surface, using the largest color
 *     component; it decides how often the surface is sampled as a light
 */
public record Emission(Texture<Rgb> radiance, boolean twoSided, double meanRadiance) {
  private static final int GRID = 16;

  public Emission {
    Objects.requireNonNull(radiance, "radiance");
  }

  /**
   * Creates an emission whose mean radiance is the mean of 16 × 16 grid points of the texture's
   * unit square.
   */
  public Emission(Texture<Rgb> radiance, boolean twoSided) {
    this(radiance, twoSided, mean(radiance));
  }

  /**
   * Returns the emission of the same radiance from all points of a surface's outside.
   *
   * @throws IllegalArgumentException if a component is negative or not finite
   */
  public static Emission of(Rgb radiance) {
    if (!radiance.isFinite() || Math.min(radiance.r(), Math.min(radiance.g(), radiance.b())) < 0) {
      throw new IllegalArgumentException(
          "radiance: expected finite components >= 0, found " + radiance);
    }
    return new Emission(Texture.constant(radiance), false);
  }

  /** Returns this emission with another mean radiance. */
  public Emission withMean(double newMeanRadiance) {
    return new Emission(radiance, twoSided, newMeanRadiance);
  }

  /**
   * Returns the radiance that leaves a point of the surface in a direction.
   *
   * @param direction direction away from the surface, in world space, of any length
   * @param normal outward geometric normal of the surface, in world space
   * @param point where the radiance is evaluated
   */
  public Rgb towards(Vec3 direction, Vec3 normal, SurfacePoint point) {
    return twoSided || direction.dot(normal) > 0 ? radiance.at(point) : Rgb.BLACK;
  }

  /**
   * Returns the radiance that a point sampled on the surface emits towards a reference point.
   *
   * @param reference point in world space
   */
  Rgb towards(Vec3 reference, SurfaceSample point) {
    return twoSided || point.isSeenFrontally(reference) ? radiance.at(point) : Rgb.BLACK;
  }

  private static double mean(Texture<Rgb> radiance) {
    double sum = 0;
    for (int i = 0; i < GRID * GRID; i++) {
      TexturePoint p =
          new TexturePoint((i % GRID + .5) / GRID, (Math.floorDiv(i, GRID) + .5) / GRID);
      sum += radiance.at(p).max();
    }
    return sum / (GRID * GRID);
  }

  /** Returns whether the emission is known to be black everywhere. */
  public boolean isBlack() {
    return radiance instanceof Constant<Rgb> constant && constant.value().isBlack();
  }
}
