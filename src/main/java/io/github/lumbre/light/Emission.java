package io.github.lumbre.light;

import io.github.lumbre.geometry.SurfaceSample;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.Constant;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.TexturePoint;
import java.util.Objects;

/**
 * The light that a surface sends out by itself.
 *
 * @param radiance the same in all directions
 * @param twoSided whether the inside shines as the outside does
 */
public record Emission(Texture<Rgb> radiance, boolean twoSided) {
  private static final int GRID = 16;

  public Emission {
    Objects.requireNonNull(radiance, "radiance");
  }

  /**
   * Returns the radiance that leaves a point of the surface.
   *
   * @param direction in which it leaves, any length
   * @param normal the surface's geometric normal, outward
   */
  public Rgb towards(Vec3 direction, Vec3 normal, TexturePoint point) {
    return twoSided || direction.dot(normal) > 0 ? radiance.at(point) : Rgb.BLACK;
  }

  /** Returns the radiance that a point drawn from the surface sends to a reference. */
  Rgb towards(Vec3 reference, SurfaceSample point) {
    return twoSided || point.isSeenFrontally(reference) ? radiance.at(point.texture()) : Rgb.BLACK;
  }

  /** Returns about the mean radiance, by its strongest component: from a grid over the texture. */
  double meanRadiance() {
    double sum = 0;
    for (int i = 0; i < GRID * GRID; i++) {
      TexturePoint p =
          new TexturePoint((i % GRID + .5) / GRID, (Math.floorDiv(i, GRID) + .5) / GRID);
      sum += radiance.at(p).max();
    }
    return sum / (GRID * GRID);
  }

  /** Returns whether nothing is emitted anywhere. */
  public boolean isBlack() {
    return radiance instanceof Constant<Rgb> constant && constant.value().isBlack();
  }
}
