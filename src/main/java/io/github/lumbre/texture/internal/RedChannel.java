package io.github.lumbre.texture.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import java.util.Objects;

/**
 * The red component of a color texture times a factor, clamped to [min, max].
 *
 * @param factor finite
 * @param min the lower limit; may be infinite
 * @param max the upper limit, at least {@code min}; may be infinite
 */
public record RedChannel(Texture<Rgb> texture, double factor, double min, double max)
    implements ScalarTexture {
  /**
   * @throws IllegalArgumentException if the range is empty, the factor is not finite or a limit is
   *     NaN
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
