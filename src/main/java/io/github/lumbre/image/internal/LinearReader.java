package io.github.lumbre.image.internal;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.file.FileContent;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.exr.ExrReader;
import io.github.lumbre.image.hdr.HdrReader;
import io.github.lumbre.image.jpeg.JpegFile;
import io.github.lumbre.image.pfm.PfmReader;
import io.github.lumbre.image.png.PngFile;
import io.github.lumbre.limit.Limits;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Objects;

/**
 * Reads picture files as linear light: OpenEXR, Radiance HDR, portable float maps, and PNG and
 * JPEG, whose values are taken for sRGB and decoded. What a PNG had lost, by clamping and by
 * rounding to 8 or 16 bits, stays lost; its alpha is not read.
 */
public final class LinearReader {
  /** The largest size of an array. */
  private static final long MAX_BYTES = Integer.MAX_VALUE - 8L;

  private LinearReader() {}

  /** Returns whether a file's content is of a format of linear light: OpenEXR, HDR or PFM. */
  public static boolean isLinear(byte[] file) {
    return ExrReader.startsIn(file) || HdrReader.startsIn(file) || PfmReader.startsIn(file);
  }

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
    return open(Files.readAllBytes(file), ImageReader.MAX_PIXELS);
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
    return open(file, ImageReader.MAX_PIXELS).intoStraight();
  }

  /**
   * Returns the picture in a file's bytes as it is stored; see {@link #decode(byte[])}.
   *
   * @param maxPixels a limit below {@link ImageReader#MAX_PIXELS}, checked before the picture is
   *     decoded
   */
  public static LinearPicture open(byte[] file, long maxPixels) throws ImageFormatException {
    Objects.requireNonNull(file, "file");
    if (ExrReader.startsIn(file)) {
      return ExrReader.read(file, maxPixels);
    }
    if (HdrReader.startsIn(file)) {
      return LinearPicture.opaque(HdrReader.read(file, maxPixels));
    }
    if (PfmReader.startsIn(file)) {
      return LinearPicture.opaque(PfmReader.read(file, maxPixels));
    }
    if (PngFile.startsIn(file) || JpegFile.startsIn(file)) {
      return LinearPicture.opaque(decoded(ImageReader.decode(file, maxPixels)));
    }
    throw malformed(
        "expected a PNG, JPEG, PFM, Radiance HDR or OpenEXR picture, found "
            + FileContent.describe(file).orElse("none of them"));
  }

  private static Image decoded(Pixels pixels) throws ImageFormatException {
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
    return new Image(width, pixels.height(), rgb, new float[0]);
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
