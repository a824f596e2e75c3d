package io.github.lumbre.texture;

import io.github.lumbre.image.Rgb;
import java.util.Objects;

/**
 * A number from a colour texture: its red component times a factor, limited to [min, max].
 *
 * @param max may be infinite
 */
public record RedChannel(Texture<Rgb> texture, double factor, double min, double max)
    implements ScalarTexture {
  /**
   * @throws IllegalArgumentException if the range is empty or a number is NaN
   */
  public RedChannel {
    Objects.requireNonNull(texture, "texture");
    if (!Double.isFinite(factor)) {
      throw new IllegalArgumentException("factor: expected a finite number, found " + factor);
    }
    if (!(min <= max)) {
      throw new IllegalArgumentException(
          "min and max: expected a range, found " + min + " to " + max);
    }
  }

  @Override
  public double at(double u, double v) {
    return Math.max(min, Math.min(factor * texture.at(u, v).r(), max));
  }
}
