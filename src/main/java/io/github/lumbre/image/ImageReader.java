package io.github.lumbre.image;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.file.FileContent;
import io.github.lumbre.image.internal.ColorTag;
import io.github.lumbre.image.internal.LinearReader;
import io.github.lumbre.image.internal.PictureLimits;
import io.github.lumbre.image.jpeg.JpegFile;
import io.github.lumbre.image.png.PngFile;
import io.github.lumbre.image.png.PngTransparency;
import io.github.lumbre.limit.Limits;
import io.github.lumbre.limit.internal.Interrupts;
import java.io.EOFException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import javax.imageio.ImageIO;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;

/**
 * Decodes picture files from untrusted sources: PNG and JPEG as they are, all formats as linear
 * light.
 *
 * <p>The header is read first. A picture that exceeds the limits, or is larger than its data can
 * hold, is rejected before memory is allocated for it. All color types and bit depths of PNG are
 * supported, and JPEG with 8 bits per channel. Values are returned as the file has them: color
 * profiles, gamma and orientation are ignored.
 */
public final class ImageReader {
  /** The largest number of pixels of a picture: 2^28. */
  public static final long MAX_PIXELS = 1L << 28;

  /** The largest width and height of a picture, in pixels. */
  public static final int MAX_SIDE = 65535;

  private ImageReader() {}

  /**
   * Checks the structure of a file without decoding the picture.
   *
   * @throws ImageFormatException if it is not the beginning of a PNG or JPEG file, or the picture
   *     is too large
   */
  public static void requireIntact(byte[] file) throws ImageFormatException {
    if (PngFile.startsIn(file)) {
      PngFile.read(file);
    } else if (JpegFile.startsIn(file)) {
      JpegFile.read(file);
    } else {
      throw unknown(file);
    }
  }

  private static ImageFormatException unknown(byte[] file) {
    String found = FileContent.describe(file).orElse("neither");
    return malformed("expected a PNG or JPEG picture, found " + found);
  }

  /**
   * Returns the picture in a file's bytes.
   *
   * @throws ImageFormatException if they are not an intact PNG or JPEG file, or the picture is too
   *     large
   * @throws CancellationException if the calling thread is interrupted, which is checked every few
   *     kilobytes; the interrupt status stays set
   */
  public static Pixels decode(byte[] file) throws ImageFormatException {
    return decode(file, MAX_PIXELS);
  }

  /**
   * Returns the picture in a file's bytes; see {@link #decode(byte[])}.
   *
   * @param maxPixels a limit below {@link #MAX_PIXELS}, checked before the picture is decoded
   */
  public static Pixels decode(byte[] file, long maxPixels) throws ImageFormatException {
    Objects.requireNonNull(file, "file");
    if (PngFile.startsIn(file)) {
      PngFile png = PngFile.read(file);
      PictureLimits.checkPixels(png.width(), png.height(), maxPixels);
      PictureLimits.checkMemory(png.width(), png.height(), 1, Limits.NONE);
      return decode("PNG", png.content(), reader -> Pixels.of(reader.read(0), png.transparency()));
    }
    if (JpegFile.startsIn(file)) {
      JpegFile jpeg = JpegFile.read(file);
      PictureLimits.checkPixels(jpeg.width(), jpeg.height(), maxPixels);
      PictureLimits.checkMemory(jpeg.width(), jpeg.height(), 1, Limits.NONE);
      return decode(
          "JPEG",
          jpeg.content(),
          reader ->
              jpeg.components() == 4
                  ? jpeg.inks(reader.readRaster(0, null))
                  : Pixels.of(reader.read(0), PngTransparency.NONE));
    }
    throw unknown(file);
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
   * or a PNG or JPEG, whose values are taken for sRGB. The content decides, not the name. The color
   * is not multiplied by alpha.
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

  /** A function that decodes the pixels with a reader whose input is set. */
  @FunctionalInterface
  private interface Decoding {
    Pixels from(javax.imageio.ImageReader reader) throws IOException;
  }

  private static Pixels decode(String format, byte[] content, Decoding decoding)
      throws ImageFormatException {
    javax.imageio.ImageReader reader = ImageIO.getImageReadersByFormatName(format).next();
    List<String> complaints = new ArrayList<>();
    reader.addIIOReadWarningListener((source, warning) -> complaints.add(warning));
    try (ImageInputStream in =
        new MemoryCacheImageInputStream(Interrupts.over(content, 0, content.length))) {
      reader.setInput(in, true, true);
      Pixels pixels = decoding.from(reader);
      for (String complaint : complaints) {
        if (!isHarmless(complaint)) {
          throw malformed(format + " is damaged: " + complaint);
        }
      }
      return pixels;
    } catch (ImageFormatException | CancellationException e) {
      throw e;
    } catch (IOException | RuntimeException | OutOfMemoryError e) {
      // For damaged files, decoders throw exceptions of any kind.
      throw failure(format, e);
    } finally {
      reader.dispose();
    }
  }

  /**
   * Returns whether a warning is about padding between segments, which some cameras write and which
   * is harmless.
   */
  private static boolean isHarmless(String warning) {
    return warning.contains("extraneous bytes before marker");
  }

  private static ImageFormatException failure(String format, Throwable thrown) {
    Throwable cause = thrown;
    while (cause.getCause() != null) {
      cause = cause.getCause();
    }
    if (cause instanceof OutOfMemoryError) {
      // The pixels are a single allocation. If it fails, nothing else is affected.
      return new ImageFormatException(
          ImageFormatException.Kind.TOO_LARGE, "the picture does not fit into memory", thrown);
    }
    String reason = cause.getMessage() == null ? "" : ": " + cause.getMessage();
    String damage = cause instanceof EOFException ? " ends too early" : " is damaged" + reason;
    return new ImageFormatException(ImageFormatException.Kind.MALFORMED, format + damage, thrown);
  }
}
