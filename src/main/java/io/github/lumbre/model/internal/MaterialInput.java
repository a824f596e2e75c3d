package io.github.lumbre.model.internal;

import io.github.lumbre.image.Rgb;
import java.util.Objects;
import java.util.Optional;

/**
 * The value of a material's parameter: a factor times a texture.
 *
 * @param factor linear RGB; three equal components of a number, or of the factor of a normal map's
 *     x and y
 * @param texture sRGB-encoded colors, linear numbers or normals; empty means 1
 * @param channel of a number's texture: 0 to 3 for red, green, blue and alpha
 */
public record MaterialInput(Rgb factor, Optional<ModelTexture> texture, int channel) {
  public MaterialInput {
    Objects.requireNonNull(factor, "factor");
    Objects.requireNonNull(texture, "texture");
  }

  /** Returns a constant color. */
  public static MaterialInput of(Rgb factor) {
    return new MaterialInput(factor, Optional.empty(), 0);
  }

  /** Returns a constant number. */
  public static MaterialInput of(double factor) {
    return of(Rgb.gray(factor));
  }

  /** Returns the factor of a number or of a normal map. */
  public double number() {
    return factor.r();
  }

  /** Returns this input with another factor. */
  public MaterialInput withFactor(Rgb newFactor) {
    return new MaterialInput(newFactor, texture, channel);
  }
}
