package io.github.lumbre.image.internal;

import io.github.lumbre.image.exr.ExrReader;
import io.github.lumbre.image.jpeg.JpegFile;
import io.github.lumbre.image.pfm.PfmReader;
import io.github.lumbre.image.png.PngFile;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/** The formats of picture files that can be written. */
public enum ImageFormat {
  /** PNG, for display: 8 or 16 bits per channel; exposure and tone curve are applied. */
  PNG,
  /** Portable float map: linear light, without alpha and metadata. */
  PFM,
  /** OpenEXR: linear light, with alpha and metadata. */
  EXR,
  /**
   * JPEG, for display: 8 bits per channel, lossy, without alpha; exposure and tone curve are
   * applied.
   */
  JPG;

  private static final String LONG_JPEG = ".jpeg";

  /** Returns the file name extension of the format with its dot, for example {@code .png}. */
  public String ending() {
    return "." + name().toLowerCase(Locale.ROOT);
  }

  /**
   * Returns the format of a file by its extension, ignoring case; empty if the extension is
   * unknown.
   */
  public static Optional<ImageFormat> of(Path file) {
    Path name = file.getFileName();
    if (name == null) {
      return Optional.empty();
    }
    String lower = name.toString().toLowerCase(Locale.ROOT);
    return lower.endsWith(LONG_JPEG)
        ? Optional.of(JPG)
        : Arrays.stream(values()).filter(format -> lower.endsWith(format.ending())).findFirst();
  }

  /**
   * Returns whether a file is a picture in any format that this package reads or writes, or a
   * Radiance HDR picture.
   *
   * @param start the first bytes of the file, at least eight if the file has that many
   */
  public static boolean startsPicture(byte[] start) {
    return PngFile.startsIn(start)
        || JpegFile.startsIn(start)
        || ExrReader.startsIn(start)
        || PfmReader.startsIn(start)
        || (start.length >= 2 && start[0] == '#' && start[1] == '?');
  }

  /** Returns whether the format is for display, so that exposure and tone curve are applied. */
  public boolean isForScreen() {
    return this == PNG || this == JPG;
  }

  /** Returns all extensions, for messages: {@code .png, .pfm, .exr, .jpg, .jpeg}. */
  public static String endings() {
    return Arrays.stream(values())
        .map(ImageFormat::ending)
        .collect(Collectors.joining(", ", "", ", " + LONG_JPEG));
  }

  /**
   * Returns the format that the ending of a name stands for.
   *
   * @throws IllegalArgumentException if there is none
   */
  public static ImageFormat require(Path file) {
    return of(file)
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    file + ": expected a name that ends in one of " + endings()));
  }
}
