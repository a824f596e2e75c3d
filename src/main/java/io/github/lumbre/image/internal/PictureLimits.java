package io.github.lumbre.image.internal;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageReader;
import java.util.Optional;

/** The limits of the sizes of pictures, checked before memory is allocated. */
public final class PictureLimits {
  private PictureLimits() {}

  /**
   * Checks that the size stated in a header is within the limits.
   *
   * @param width in pixels, unsigned
   * @param height in pixels, unsigned
   */
  public static void checkSize(int width, int height) throws ImageFormatException {
    if (width == 0 || height == 0) {
      throw malformed("the picture has no pixels");
    }
    long w = Integer.toUnsignedLong(width);
    long h = Integer.toUnsignedLong(height);
    if (w > ImageReader.MAX_SIDE || h > ImageReader.MAX_SIDE || w * h > ImageReader.MAX_PIXELS) {
      throw new ImageFormatException(
          ImageFormatException.Kind.TOO_LARGE,
          "the picture has %dx%d pixels, expected at most %d per side and %d in total"
              .formatted(w, h, ImageReader.MAX_SIDE, ImageReader.MAX_PIXELS));
    }
  }

  /** Checks that a picture has at most a number of pixels. */
  public static void checkPixels(int width, int height, long maxPixels)
      throws ImageFormatException {
    if ((long) width * height > maxPixels) {
      throw new ImageFormatException(
          ImageFormatException.Kind.TOO_LARGE,
          "the picture has %dx%d pixels, expected at most %d in total"
              .formatted(width, height, maxPixels));
    }
  }

  /** Checks that a picture fits into the heap, and the memory that the limits allow. */
  public static void checkMemory(int width, int height, int bytesPerPixel, Limits limits)
      throws ImageFormatException {
    checkBytes(width, height, (long) bytesPerPixel * width * height, limits);
  }

  /**
   * Checks that what reading a picture allocates fits into the heap, and the memory that the limits
   * allow.
   */
  public static void checkBytes(int width, int height, long bytes, Limits limits)
      throws ImageFormatException {
    Optional<String> excess = Limits.excess("bytes of memory", limits.heap(), bytes);
    if (excess.isPresent()) {
      throw new ImageFormatException(
          ImageFormatException.Kind.TOO_LARGE,
          "the picture has %dx%d pixels: %s".formatted(width, height, excess.get()));
    }
  }
}
