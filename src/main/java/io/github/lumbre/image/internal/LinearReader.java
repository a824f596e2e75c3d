package io.github.lumbre.image.internal;


import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;

/**
 * Reads picture files as linear light: OpenEXR, Radiance HDR, portable float maps, and PNG and
 * JPEG, whose values are taken for sRGB and decoded. What a PNG had lost, by clamping and by
 * rounding to 8 or 16 bits, stays lost; its alpha is not read.
 */
public final class LinearReader {
  /** The largest size of an array. */
  private static final long MAX_BYTES = Integer.MAX_VALUE - 8L;

  private LinearReader() {}

  /**
   * Returns the picture in a file, whose format is recognized by its content, not by its name. Its
   * color is straight; see {@link LinearPicture#straight}.
   *
   * @throws ImageFormatException if the file is in none of the formats, damaged or too large
   * @throws IOException if the file cannot be read
   */
  public static Image read(Path file) throws IOException {
    return open(file).intoStraight();
  }

  /**
   * Returns the picture in a file as it is stored; see {@link #read}.
   *
   * @throws ImageFormatException if the file is in none of the formats, damaged or too large
   * @throws IOException if the file cannot be read
   */
  public static LinearPicture open(Path file) throws IOException {
    long bytes = Files.size(file);
    if (bytes > MAX_BYTES) {
      throw new ImageFormatException(
          ImageFormatException.Kind.TOO_LARGE,
          "the file has " + bytes + " bytes, expected at most " + MAX_BYTES);
    }
    return ImageFormat.read(Files.readAllBytes(file), ImageReader.MAX_PIXELS);
  }

  /**
   * Returns the picture in a file's bytes. Its color is straight; see {@link
   * LinearPicture#straight}.
   *
   * @throws ImageFormatException if they are none of the formats, or damaged, or too large
   * @throws java.util.concurrent.CancellationException if the calling thread is interrupted; the
   *     interrupt status stays set
   */
  public static Image decode(byte[] file) throws ImageFormatException {
    return ImageFormat.read(file, ImageReader.MAX_PIXELS).intoStraight();
  }

  /** Returns an 8-bit or 16-bit picture as linear light. */
  static LinearPicture decoded(Pixels pixels) throws ImageFormatException {
    int width = pixels.width();
    float[] rgb = raster(width, pixels.height(), 3);
    // A picture has few different values, and a power takes far longer than reading a pixel.
    float[] decoded = new float[pixels.max() + 1];
    Arrays.fill(decoded, Float.NaN);
    for (int i = 0; i < rgb.length; i++) {
      int pixel = i / 3;
      int raw = pixels.raw(pixel % width, pixel / width, i % 3);
      if (Float.isNaN(decoded[raw])) {
        decoded[raw] = (float) Srgb.decode((double) raw / pixels.max());
      }
      rgb[i] = decoded[raw];
    }
    return new LinearPicture(width, pixels.height(), rgb, new float[0]);
  }

  /**
   * Returns an array for a picture whose size is within the limits.
   *
   * @throws ImageFormatException if the picture does not fit into the heap; nothing is allocated
   *     then
   */
  public static float[] raster(int width, int height, int channels) throws ImageFormatException {
    PictureLimits.checkMemory(width, height, channels * Float.BYTES, Limits.NONE);
    try {
      return new float[Math.multiplyExact(channels, width * height)];
    } catch (OutOfMemoryError e) {
      // A single allocation. If it fails, nothing else is affected.
      throw new ImageFormatException(
          ImageFormatException.Kind.TOO_LARGE, "the picture does not fit into memory", e);
    }
  }
}
