package io.github.lumbre.image;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.internal.ColorTag;
import io.github.lumbre.image.internal.EncodedFormat;
import io.github.lumbre.image.internal.EncodedPicture;
import io.github.lumbre.image.internal.LinearReader;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CancellationException;

/**
 * Decodes picture files from untrusted sources: PNG, JPEG, WebP, KTX 2, DDS, BMP, GIF, TIFF and TGA
 * as they are, all formats as linear light. The content decides, not the name.
 *
 * <p>The header is read first. A picture that exceeds the limits, or is larger than its data can
 * hold, is rejected before memory is allocated for it. All color types and bit depths of PNG are
 * supported, JPEG with 8 bits per channel, still WebP pictures of all kinds, and TGA, packed or
 * not. Values are returned as the file has them: color profiles, gamma and orientation are ignored.
 */
public final class ImageReader {
  /** The largest number of pixels of a picture: 2^28. */
  public static final long MAX_PIXELS = 1L << 28;

  /** The largest width and height of a picture, in pixels. */
  public static final int MAX_SIDE = 65535;

  private ImageReader() {}

  /**
   * Returns the picture in a file's bytes.
   *
   * @throws ImageFormatException if they are not an intact file of a supported format, or the
   *     picture is too large
   * @throws CancellationException if the calling thread is interrupted, which is checked every few
   *     kilobytes; the interrupt status stays set
   */
  public static Pixels decode(byte[] file) throws ImageFormatException {
    return decode(file, Limits.NONE);
  }

  /**
   * Returns the picture in a file's bytes; see {@link #decode(byte[])}.
   *
   * @param limits whose texels, memory and formats are checked before the picture is decoded
   */
  public static Pixels decode(byte[] file, Limits limits) throws ImageFormatException {
    Objects.requireNonNull(file, "file");
    EncodedPicture picture = EncodedFormat.open(file, limits);
    try {
      return picture.decoder().decode();
    } catch (OutOfMemoryError e) {
      // The pixels are a single allocation. If it fails, nothing else is affected.
      throw new ImageFormatException(
          ImageFormatException.Kind.TOO_LARGE, "the picture does not fit into memory", e);
    }
  }

  /**
   * Returns the color space that a file states and {@link #decode} ignores, such as "an ICC profile
   * (Adobe RGB (1998))" or "a gamma of 1.0"; empty if it states none, or sRGB. The text comes from
   * the file and may contain any characters.
   */
  public static Optional<String> ignoredColorSpace(byte[] file) {
    return ColorTag.ignoredIn(Objects.requireNonNull(file, "file"));
  }

  /**
   * Returns the picture in a file as linear light: OpenEXR, Radiance HDR or a portable float map,
   * or any format of {@link #decode}, whose values are taken for sRGB. The content decides, not the
   * name. The color is not multiplied by alpha.
   *
   * @throws ImageFormatException if the file is in none of the formats, damaged or too large
   * @throws IOException if the file cannot be read
   */
  public static Image readLinear(Path file) throws IOException {
    return LinearReader.read(file);
  }

  /**
   * Returns the picture in a file's bytes as linear light; see {@link #readLinear}.
   *
   * @throws ImageFormatException if they are none of the formats, or damaged, or too large
   * @throws CancellationException if the calling thread is interrupted; the interrupt status stays
   *     set
   */
  public static Image decodeLinear(byte[] file) throws ImageFormatException {
    return LinearReader.decode(file);
  }
}
