package io.github.lumbre.image;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/** A kind of picture file that can be written. */
public enum ImageFormat {
  /** 8 or 16 bits a channel, for the screen: exposure and tone curve are applied. */
  PNG,
  /** Portable float map: linear light, no alpha, no metadata. */
  PFM,
  /** OpenEXR: linear light, alpha and metadata. */
  EXR,
  /** 8 bits a channel, for the screen, with loss: exposure and tone curve are applied, no alpha. */
  JPG;

  private static final String LONG_JPEG = ".jpeg";

  /** Returns the ending of the format's files, with its dot: {@code .png}. */
  public String ending() {
    return "." + name().toLowerCase(Locale.ROOT);
  }

  /** Returns the format that a file's ending names, in any case, or empty if it names none. */
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
   * Returns whether a file is a picture of any kind that this package writes or reads, or a
   * Radiance HDR picture.
   *
   * @param start the first bytes of the file, at least eight of them if it has so many
   */
  public static boolean startsPicture(byte[] start) {
    return PngFile.startsIn(start)
        || JpegFile.startsIn(start)
        || ExrReader.startsIn(start)
        || PfmReader.startsIn(start)
        || (start.length >= 2 && start[0] == '#' && start[1] == '?');
  }

  /** Returns whether pictures are for the screen: exposure and tone curve are applied. */
  public boolean isForScreen() {
    return this == PNG || this == JPG;
  }

  /** Returns all endings, for messages: {@code .png, .pfm, .exr, .jpg, .jpeg}. */
  public static String endings() {
    return Arrays.stream(values())
        .map(ImageFormat::ending)
        .collect(Collectors.joining(", ", "", ", " + LONG_JPEG));
  }
}
