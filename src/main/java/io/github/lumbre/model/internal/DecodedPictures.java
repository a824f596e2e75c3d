package io.github.lumbre.model.internal;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.internal.PictureLimits;
import java.nio.ByteBuffer;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * The pictures of a model that is read anew for each of its poses: equal files are decoded once.
 * Safe for use by several threads.
 */
public final class DecodedPictures {
  private final Map<ByteBuffer, Pixels> known = new ConcurrentHashMap<>();

  /**
   * Returns the picture in a file.
   *
   * @param file must not be changed afterwards
   * @throws ImageFormatException if the file cannot be decoded, or exceeds a limit
   */
  Pixels of(byte[] file, Limits limits) throws ImageFormatException {
    ByteBuffer key = ByteBuffer.wrap(file);
    Pixels pixels = known.get(key);
    if (pixels == null) {
      pixels = ImageReader.decode(file, limits);
      known.put(key, pixels);
    } else {
      PictureLimits.checkPixels(pixels.width(), pixels.height(), limits.texels());
    }
    return pixels;
  }
}
