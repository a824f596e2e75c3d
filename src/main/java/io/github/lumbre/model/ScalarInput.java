package io.github.lumbre.model;

import java.util.Objects;
import java.util.Optional;

/**
 * A number parameter of a material: a factor times one channel of a texture.
 *
 * @param texture linear values in [0,1]; empty means 1
 * @param channel of the texture: 0 to 3 for red, green, blue and alpha
 */
public record ScalarInput(double factor, Optional<ModelTexture> texture, int channel) {

  /** Returns an input without a texture. */
  public static ScalarInput of(double factor) {
    return new ScalarInput(factor, Optional.empty(), 0);
  }

  public ScalarInput {
    Objects.requireNonNull(texture, "texture");
  }
}
