package io.github.lumbre.image.internal;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.base.file.FileContent;
import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.format.exr.ExrReader;
import io.github.lumbre.image.format.exr.ExrWriter;
import io.github.lumbre.image.format.hdr.HdrReader;
import io.github.lumbre.image.format.jpeg.JpegFile;
import io.github.lumbre.image.format.jpeg.JpegWriter;
import io.github.lumbre.image.format.pfm.PfmReader;
import io.github.lumbre.image.format.pfm.PfmWriter;
import io.github.lumbre.image.format.png.PngFile;
import io.github.lumbre.image.format.png.PngWriter;
import io.github.lumbre.image.format.svg.SvgWriter;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * The formats of picture files: the constants are those that can be written, and {@link #read}
 * reads some more. Only this class and {@link EncodedFormat} name the packages of all formats.
 */
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
  JPG,
  /** SVG: lines and areas of a {@link VectorPicture}; pixels cannot be written. */
  SVG;

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
   * Returns whether a file is a picture in any format that can be read.
   *
   * @param start the first bytes of the file, at least eight if the file has that many
   */
  public static boolean startsPicture(byte[] start) {
    return PngFile.startsIn(start) || JpegFile.startsIn(start) || startsLinear(start);
  }

  /**
   * Returns whether a file is of a format of linear light: OpenEXR, Radiance HDR or PFM.
   *
   * @param start the first bytes of the file, at least eight if the file has that many
   */
  public static boolean startsLinear(byte[] start) {
    return ExrReader.startsIn(start) || HdrReader.startsIn(start) || PfmReader.startsIn(start);
  }

  /**
   * Returns the picture in a file's bytes as linear light, as it is stored.
   *
   * @param maxPixels a limit of at most {@link ImageReader#MAX_PIXELS}, checked before the picture
   *     is decoded
   * @throws ImageFormatException if the file is in none of the formats, damaged or too large
   * @throws java.util.concurrent.CancellationException if the calling thread is interrupted; the
   *     interrupt status stays set
   */
  public static LinearPicture read(byte[] file, long maxPixels) throws ImageFormatException {
    return read(file, Limits.NONE.withTexels(maxPixels));
  }

  /**
   * Returns the picture in a file's bytes as {@link #read(byte[], long)} does.
   *
   * @param limits of its texels, and of its format
   */
  public static LinearPicture read(byte[] file, Limits limits) throws ImageFormatException {
    long maxPixels = limits.texels();
    if (ExrReader.startsIn(file)) {
      return ExrReader.read(file, maxPixels);
    }
    if (HdrReader.startsIn(file)) {
      return HdrReader.read(file, maxPixels);
    }
    if (PfmReader.startsIn(file)) {
      return PfmReader.read(file, maxPixels);
    }
    if (EncodedFormat.isIn(file)) {
      return LinearReader.decoded(ImageReader.decode(file, limits));
    }
    throw malformed(
        "expected an OpenEXR, Radiance HDR, PFM, %s picture, found %s"
            .formatted(EncodedFormat.titles(), FileContent.describe(file).orElse("none of them")));
  }

  /** Writes a picture to a channel at position 0 and leaves the channel open. */
  public void write(
      Image image,
      List<ImageLayer> layers,
      ImageWriter.Options options,
      SeekableByteChannel channel)
      throws IOException {
    if (!layers.isEmpty() && this != EXR) {
      throw new IllegalArgumentException("layers: expected an .exr file, found " + ending());
    }
    Objects.requireNonNull(image, "image");
    Objects.requireNonNull(options, "options");
    OutputStream out = PictureEncoder.buffered(channel);
    Image light = isForScreen() ? image : Backdrop.asLight(image, options.background());
    switch (this) {
      case PNG -> PngWriter.write(image, options, out);
      case JPG -> JpegWriter.write(image, options, out);
      case PFM -> PfmWriter.write(light, out);
      case EXR -> ExrWriter.write(light, layers, options.metadata(), channel);
      case SVG -> throw new IllegalArgumentException("expected a drawing, found pixels");
    }
    out.flush();
  }

  /**
   * Writes a drawing to a channel at position 0 and leaves the channel open.
   *
   * @throws IllegalArgumentException if the format has pixels
   */
  public void write(VectorPicture picture, SeekableByteChannel channel) throws IOException {
    if (!isVector()) {
      throw new IllegalArgumentException("expected pixels, found a drawing");
    }
    OutputStream out = PictureEncoder.buffered(channel);
    SvgWriter.write(picture, out);
    out.flush();
  }

  /**
   * Returns the bytes of a file: those that {@link ImageWriter} writes.
   *
   * @throws IllegalArgumentException if the picture is too large for the format
   */
  public byte[] bytes(Image image, ImageWriter.Options options) {
    MemoryChannel channel = new MemoryChannel();
    try {
      write(image, List.of(), options, channel);
    } catch (IOException e) {
      throw new IllegalArgumentException(image + ": " + e.getMessage(), e);
    }
    return channel.toBytes();
  }

  /** Returns whether the format is for display, so that exposure and tone curve are applied. */
  public boolean isForScreen() {
    return this == PNG || this == JPG;
  }

  /** Returns whether the format has lines and areas instead of pixels. */
  public boolean isVector() {
    return this == SVG;
  }

  /** Returns the extensions of pixels, for messages: {@code .png, .pfm, .exr, .jpg, .jpeg}. */
  public static String endings() {
    return Arrays.stream(values())
        .filter(format -> !format.isVector())
        .map(ImageFormat::ending)
        .collect(Collectors.joining(", ", "", ", " + LONG_JPEG));
  }

  /**
   * Returns the format of pixels that the ending of a name stands for.
   *
   * @throws IllegalArgumentException if there is none
   */
  public static ImageFormat require(Path file) {
    return of(file)
        .filter(format -> !format.isVector())
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    file + ": expected a name that ends in one of " + endings()));
  }
}
