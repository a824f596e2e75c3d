package io.github.lumbre.model;

import java.util.Objects;

/**
 * A tangent-space normal map.
 *
 * @param scale factor of the normals' x and y
 */
public record NormalInput(ModelTexture texture, double scale) {
  public NormalInput {
    Objects.requireNonNull(texture, "texture");
  }
}
