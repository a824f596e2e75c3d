package io.github.lumbre.image.internal;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.base.file.FileContent;
import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.format.dds.DdsFile;
import io.github.lumbre.image.format.imageio.BmpFile;
import io.github.lumbre.image.format.imageio.GifFile;
import io.github.lumbre.image.format.imageio.JdkDecoder;
import io.github.lumbre.image.format.imageio.TiffFile;
import io.github.lumbre.image.format.jpeg.JpegFile;
import io.github.lumbre.image.format.ktx.KtxFile;
import io.github.lumbre.image.format.png.PngFile;
import io.github.lumbre.image.format.tga.TgaFile;
import io.github.lumbre.image.format.webp.WebpFile;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/**
 * The formats of pictures of encoded values, with 8 or 16 bits per channel, in the order in which a
 * file is compared with them. {@link ImageFormat} adds those of linear light.
 */
public enum EncodedFormat {
  PNG("PNG", PngFile::startsIn, PngFile::open),
  JPEG("JPEG", JpegFile::startsIn, EncodedFormat::jpeg),
  WEBP("WebP", WebpFile::startsIn, WebpFile::open),
  KTX("KTX 2", KtxFile::startsIn, KtxFile::open),
  DDS("DDS", DdsFile::startsIn, DdsFile::open),
  BMP("BMP", BmpFile::startsIn, BmpFile::open),
  GIF("GIF", GifFile::startsIn, GifFile::open),
  TIFF("TIFF", TiffFile::startsIn, TiffFile::open),
  /** Has no signature, so it comes last. */
  TGA("TGA", TgaFile::isIn, TgaFile::open);

  /** Reads the header of a file. */
  @FunctionalInterface
  private interface Opening {
    EncodedPicture open(byte[] file) throws ImageFormatException;
  }

  private final String title;
  private final Predicate<byte[]> recognizer;
  private final Opening opening;

  EncodedFormat(String title, Predicate<byte[]> recognizer, Opening opening) {
    this.title = title;
    this.recognizer = recognizer;
    this.opening = opening;
  }

  private static final Set<EncodedFormat> LEGACY = EnumSet.of(BMP, GIF, TIFF);

  /**
   * Reads the header of a file.
   *
   * @param limits of the size of the picture, and of its format
   * @throws ImageFormatException if it is none of the formats, or damaged, or exceeds the limits
   */
  public static EncodedPicture open(byte[] file, Limits limits) throws ImageFormatException {
    Optional<EncodedFormat> format = of(file);
    if (format.isEmpty()) {
      String found = FileContent.describe(file).orElse("none of them");
      throw malformed("expected a " + titles() + " picture, found " + found);
    }
    if (LEGACY.contains(format.get()) && !limits.legacyPictures()) {
      throw malformed(
          "found a "
              + format.get().title
              + " picture, which these limits refuse; save it as a PNG or JPEG, or call"
              + " Limits.withLegacyPictures(true)");
    }
    EncodedPicture picture = format.get().opening.open(file);
    int width = picture.width();
    PictureLimits.checkPixels(width, picture.height(), limits.texels());
    PictureLimits.checkMemory(width, picture.height(), picture.bytesPerPixel(), limits);
    return picture;
  }

  /** Returns whether a file has pictures besides the one that is decoded. */
  public static boolean hasMorePictures(byte[] file) {
    try {
      return GifFile.startsIn(file) && GifFile.hasMorePictures(file)
          || TiffFile.startsIn(file) && TiffFile.hasMorePictures(file);
    } catch (IndexOutOfBoundsException | ImageFormatException e) {
      return false; // The file is damaged. Decoding reports that.
    }
  }

  /** Returns whether a file is of any of the formats. */
  static boolean isIn(byte[] file) {
    return of(file).isPresent();
  }

  private static Optional<EncodedFormat> of(byte[] file) {
    return Arrays.stream(values()).filter(format -> format.recognizer.test(file)).findFirst();
  }

  /** Returns the names of all formats: {@code PNG, JPEG, WebP, KTX 2 or TGA}. */
  public static String titles() {
    String titles = Arrays.stream(values()).map(f -> f.title).collect(Collectors.joining(", "));
    int last = titles.lastIndexOf(',');
    return titles.substring(0, last) + " or" + titles.substring(last + 1);
  }

  private static EncodedPicture jpeg(byte[] file) throws ImageFormatException {
    JpegFile jpeg = JpegFile.read(file);
    // Inks are decoded first, and then become colors.
    int bytes = jpeg.components() == 4 ? 4 + 3 : jpeg.components();
    return new EncodedPicture(jpeg.width(), jpeg.height(), bytes, () -> JdkDecoder.decode(jpeg));
  }
}
