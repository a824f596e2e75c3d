package io.github.lumbre.model.internal;

import java.util.Objects;

/**
 * A picture with its sampling parameters.
 *
 * @param uvSet 0 or 1: the set of texture coordinates
 * @param wrapU what happens outside u in [0,1)
 * @param wrapV as wrapU, for v
 * @param nearest whether to use the texel that contains a point, instead of linear interpolation
 * @param uvTransform applied to the texture coordinates before wrapping
 */
public record ModelTexture(
    ModelImage image, int uvSet, Wrap wrapU, Wrap wrapV, boolean nearest, UvTransform uvTransform) {

  /** How a texture continues outside [0,1). */
  public enum Wrap {
    /** It repeats. */
    REPEAT,
    /** It repeats, and every second copy is mirrored. */
    MIRROR,
    /** Its border texels continue. */
    CLAMP
  }

  public ModelTexture {
    Objects.requireNonNull(image, "image");
    Objects.requireNonNull(wrapU, "wrapU");
    Objects.requireNonNull(wrapV, "wrapV");
    Objects.requireNonNull(uvTransform, "uvTransform");
  }
}
