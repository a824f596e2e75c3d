package io.github.lumbre.model;

import io.github.lumbre.image.Rgb;
import java.util.Objects;
import java.util.Optional;

/**
 * A color parameter of a material: a linear factor times a texture.
 *
 * @param factor linear RGB
 * @param texture sRGB-encoded colors; empty means white
 */
public record ColorInput(Rgb factor, Optional<ModelTexture> texture) {

  /** Returns an input without a texture. */
  public static ColorInput of(Rgb factor) {
    return new ColorInput(factor, Optional.empty());
  }

  public ColorInput {
    Objects.requireNonNull(factor, "factor");
    Objects.requireNonNull(texture, "texture");
  }
}
