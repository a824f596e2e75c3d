package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;

/** Checks the plain values of materials and makes constant textures of them. */
final class Values {
  private Values() {}

  /**
   * Returns a constant texture of a reflectance.
   *
   * @throws IllegalArgumentException if a component is not in [0, 1]
   */
  static Texture<Rgb> reflectance(String name, Rgb color) {
    boolean isInRange =
        color.r() >= 0 && color.g() >= 0 && color.b() >= 0 && color.max() <= 1 && color.isFinite();
    if (!isInRange) {
      throw new IllegalArgumentException(
          name + ": expected components from 0 to 1, found " + color);
    }
    return Texture.constant(color);
  }

  /**
   * Returns a constant texture of a number.
   *
   * @throws IllegalArgumentException if the number is not in the range
   */
  static ScalarTexture number(String name, double value, Range range) {
    return ScalarTexture.constant(range.require(name, value));
  }
}
