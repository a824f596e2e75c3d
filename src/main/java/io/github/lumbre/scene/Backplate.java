package io.github.lumbre.scene;

import io.github.lumbre.image.Rgb;
import java.util.Objects;

/**
 * What the camera sees instead of environment lights, which still give light: one radiance for each
 * row of the full frame, which changes linearly from the top to the bottom. Rays that have passed
 * straight through transparent surfaces see it, too; mirrors and refraction do not.
 *
 * @param top radiance at the upper edge of the full frame
 * @param bottom radiance at the lower edge
 */
public record Backplate(Rgb top, Rgb bottom) {
  /**
   * @throws IllegalArgumentException if a component is negative, infinite or NaN
   */
  public Backplate {
    require(top, "top");
    require(bottom, "bottom");
  }

  private static void require(Rgb radiance, String name) {
    Objects.requireNonNull(radiance, name);
    double least = Math.min(radiance.r(), Math.min(radiance.g(), radiance.b()));
    if (!radiance.isFinite() || least < 0) {
      throw new IllegalArgumentException(
          name + ": expected finite components of at least 0, found " + radiance);
    }
  }

  /** Returns a backplate of one radiance. */
  public static Backplate plain(Rgb radiance) {
    return new Backplate(radiance, radiance);
  }

  /** Returns whether all rows have the same radiance. */
  public boolean isPlain() {
    return top.equals(bottom);
  }

  /**
   * Returns the radiance of a row.
   *
   * @param down the row's distance from the upper edge divided by the height of the full frame, 0 to
   *     1
   */
  public Rgb at(double down) {
    return isPlain() ? top : top.times(1 - down).plus(bottom.times(down));
  }
}
