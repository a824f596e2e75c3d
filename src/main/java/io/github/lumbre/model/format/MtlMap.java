package io.github.lumbre.model.format;

import io.github.lumbre.model.internal.ModelTexture.Wrap;
import io.github.lumbre.model.internal.UvTransform;

/**
 * A texture statement of a material library.
 *
 * @param file name relative to the model's folder
 * @param channel the channel of scalar textures, 0 to 3; -1 if none is stated
 * @param bumpScale factor of a bump or normal map
 */
public record MtlMap(
    String location,
    String file,
    int channel,
    double bumpScale,
    Wrap wrap,
    UvTransform uvTransform) {

  /** Returns a file name with / between folders, without "./" at its beginning. */
  public static String portable(String name) {
    String portable = name.replace('\\', '/');
    while (portable.startsWith("./")) {
      portable = portable.substring(2);
    }
    return portable;
  }
}
