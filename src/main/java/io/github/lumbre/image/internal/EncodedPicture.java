package io.github.lumbre.image.internal;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.Pixels;

/**
 * A picture file of encoded values whose header has been read and whose size is within the limits
 * of all pictures.
 *
 * @param width in pixels
 * @param height in pixels
 * @param bytesPerPixel memory that decoding takes, without a few megabytes
 */
public record EncodedPicture(int width, int height, int bytesPerPixel, Decoder decoder) {
  @FunctionalInterface
  public interface Decoder {
    /**
     * Returns the picture.
     *
     * @throws ImageFormatException if the file is damaged or the picture does not fit into memory
     * @throws java.util.concurrent.CancellationException if the calling thread is interrupted; the
     *     interrupt status stays set
     */
    Pixels decode() throws ImageFormatException;
  }
}
