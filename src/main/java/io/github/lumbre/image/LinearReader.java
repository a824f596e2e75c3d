package io.github.lumbre.image;

import static io.github.lumbre.image.ImageFormatException.malformed;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;

/**
 * Reads picture files as linear light, whichever they are: OpenEXR files as {@link ImageWriter}
 * makes them, portable float maps, and PNG and JPEG files, whose values are taken for sRGB and
 * decoded. What a PNG had lost, by clamping and by rounding to 8 or 16 bits, stays lost; its alpha
 * is not read.
 */
public final class LinearReader {
  private LinearReader() {}

  /**
   * Returns the picture in a file; its content tells what it is, not its name.
   *
   * @throws ImageFormatException if the file is none of the formats, or damaged, or too large
   * @throws IOException if the file cannot be read
   */
  public static Image read(Path file) throws IOException {
    return decode(Files.readAllBytes(file));
  }

  /**
   * Returns the picture in a file's bytes.
   *
   * @throws ImageFormatException if they are none of the formats, or damaged, or too large
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

  private static Image decoded(Pixels pixels) {
    int width = pixels.width();
    float[] rgb = new float[Math.multiplyExact(3, width * pixels.height())];
    for (int i = 0; i < rgb.length; i++) {
      int pixel = i / 3;
      rgb[i] = (float) Srgb.decode(pixels.value(pixel % width, pixel / width, i % 3));
    }
    return new Image(width, pixels.height(), rgb, new float[0]);
  }
}
