package io.github.lumbre.scene;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import java.util.Objects;
import java.util.Optional;

/**
 * What the camera sees instead of environment lights, which still give light: one radiance for each
 * row of the full frame, which changes linearly from the top to the bottom. Rays that have passed
 * straight through transparent surfaces see it, too; mirrors and refraction do not.
 *
 * @param top radiance at the upper edge of the full frame
 * @param bottom radiance at the lower edge
 * @param shadowOf a box around objects whose contact shadow a view from above shows, on the ground
 *     on which the box stands; y points up. Empty for no shadow
 */
public record Backplate(Rgb top, Rgb bottom, Optional<Bounds3> shadowOf) {
  /**
   * @throws IllegalArgumentException if a component is negative, infinite or NaN, or if the box is
   *     empty or infinite
   */
  public Backplate {
    require(top, "top");
    require(bottom, "bottom");
    Bounds3 box = shadowOf.orElse(new Bounds3(Vec3.ZERO, Vec3.ZERO));
    if (box.isEmpty() || !box.isFinite()) {
      throw new IllegalArgumentException("shadowOf: expected a finite box, found " + box);
    }
  }

  /** Creates a backplate without a shadow. */
  public Backplate(Rgb top, Rgb bottom) {
    this(top, bottom, Optional.empty());
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

  /** Returns the same backplate with the contact shadow of what is in a box. */
  public Backplate withShadowOf(Bounds3 box) {
    return new Backplate(top, bottom, Optional.of(box));
  }

  /** Returns whether all rows have the same radiance. */
  public boolean isPlain() {
    return top.equals(bottom);
  }

  /**
   * Returns the radiance of a row.
   *
   * @param down the row's distance from the upper edge divided by the height of the full frame, 0
   *     to 1
   */
  public Rgb at(double down) {
    return isPlain() ? top : top.times(1 - down).plus(bottom.times(down));
  }
}
