package io.github.lumbre.image;

import static io.github.lumbre.image.ImageFormatException.malformed;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;

/**
 * Reads picture files of any supported format as linear RGB: OpenEXR files as {@link ImageWriter}
 * writes them, portable float maps, and PNG and JPEG files, whose values are decoded as sRGB.
 * Clamping and rounding to 8 or 16 bits cannot be undone. The alpha of a PNG is not read.
 */
public final class LinearReader {
  /** The largest size of an array. */
  private static final long MAX_BYTES = Integer.MAX_VALUE - 8L;

  private LinearReader() {}

  /**
   * Returns the picture in a file, whose format is recognized by its content, not by its name.
   *
   * @throws ImageFormatException if the file is in none of the formats, damaged or too large
   * @throws IOException if the file cannot be read
   */
  public static Image read(Path file) throws IOException {
    long bytes = Files.size(file);
    if (bytes > MAX_BYTES) {
      throw new ImageFormatException(
          ImageFormatException.Kind.TOO_LARGE,
          "the file has " + bytes + " bytes, expected at most " + MAX_BYTES);
    }
    return decode(Files.readAllBytes(file));
  }

  /**
   * Returns the picture in a file's bytes.
   *
   * @throws ImageFormatException if they are in none of the formats, damaged or too large
   */
  public static Image decode(byte[] file) throws ImageFormatException {
    Objects.requireNonNull(file, "file");
    if (ExrReader.startsIn(file)) {
      return ExrReader.read(file);
    }
    if (PfmReader.startsIn(file)) {
      return PfmReader.read(file);
    }
    if (PngFile.startsIn(file) || JpegFile.startsIn(file)) {
      return decoded(ImageReader.decode(file));
    }
    throw malformed("expected a PNG, JPEG, PFM or OpenEXR picture, found none of them");
  }

  private static Image decoded(Pixels pixels) throws ImageFormatException {
    int width = pixels.width();
    float[] rgb = raster(width, pixels.height(), 3);
    for (int i = 0; i < rgb.length; i++) {
      int pixel = i / 3;
      rgb[i] = (float) Srgb.decode(pixels.value(pixel % width, pixel / width, i % 3));
    }
    return new Image(width, pixels.height(), rgb, new float[0]);
  }

  /**
   * Returns an array for a picture whose size is within the limits.
   *
   * @throws ImageFormatException if the picture does not fit into the heap; nothing is allocated
   *     then
   */
  static float[] raster(int width, int height, int channels) throws ImageFormatException {
    long maxHeapBytes = Runtime.getRuntime().maxMemory();
    ImageReader.checkMemory(width, height, channels * Float.BYTES, maxHeapBytes);
    return new float[Math.multiplyExact(channels, width * height)];
  }
}
