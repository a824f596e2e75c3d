package io.github.lumbre.image;

import io.github.lumbre.file.OutputFile;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * Writes pictures to files, in the {@link ImageFormat} given by the file name extension.
 *
 * <p>PNG and JPEG are for display: exposure and tone curve are applied. Alpha stays straight in
 * PNG; a JPEG has no alpha and shows the picture over black. PFM and OpenEXR store linear light
 * without exposure. They store infinite values as ±{@link Float#MAX_VALUE} and NaN as 0. In
 * OpenEXR, colors are multiplied by alpha where that is not 0, as the format requires; PFM has no
 * alpha.
 *
 * <p>A file appears complete or not at all; see {@link OutputFile}.
 */
public final class ImageWriter {
  /** The largest width and height of a JPEG that the encoder can write, in pixels. */
  public static final int MAX_JPEG_SIDE = 65500;

  private static final int BUFFER_BYTES = 1 << 16;

  private ImageWriter() {}

  /**
   * The options for writing a picture.
   *
   * @param exposure used by PNG and JPEG only
   * @param curve tone curve, used by PNG and JPEG only
   * @param pngBits bits per channel of a PNG, 8 or 16
   * @param jpegQuality quality of a JPEG, from 1 (smallest file) to 100
   * @param metadata texts by keyword, in the order in which they are written; used by PNG, JPEG and
   *     OpenEXR. A keyword has 1 to 79 printable ASCII characters, no leading, trailing or
   *     consecutive spaces, and is not a name that OpenEXR reserves
   */
  public record Options(
      Exposure exposure,
      ToneCurve curve,
      int pngBits,
      int jpegQuality,
      Map<String, String> metadata) {
    /** The default quality of a JPEG. */
    public static final int DEFAULT_JPEG_QUALITY = 90;

    /** The defaults: no exposure, the sRGB curve, 8 bits, no metadata. */
    public static final Options DEFAULT = new Options(Exposure.NONE, ToneCurve.SRGB, 8, Map.of());

    /** Creates options with {@link #DEFAULT_JPEG_QUALITY}. */
    public Options(Exposure exposure, ToneCurve curve, int pngBits, Map<String, String> metadata) {
      this(exposure, curve, pngBits, DEFAULT_JPEG_QUALITY, metadata);
    }

    /**
     * @throws IllegalArgumentException if a number or keyword is invalid
     */
    public Options {
      Objects.requireNonNull(exposure, "exposure");
      Objects.requireNonNull(curve, "curve");
      if (pngBits != 8 && pngBits != 16) {
        throw new IllegalArgumentException("pngBits: expected 8 or 16, found " + pngBits);
      }
      if (jpegQuality < 1 || jpegQuality > 100) {
        throw new IllegalArgumentException("jpegQuality: expected 1 to 100, found " + jpegQuality);
      }
      metadata = Collections.unmodifiableMap(new LinkedHashMap<>(metadata));
      metadata.forEach(Options::check);
    }

    private static void check(String keyword, String text) {
      Objects.requireNonNull(text, keyword);
      boolean printable = keyword.chars().allMatch(c -> c >= ' ' && c <= '~');
      boolean spaced = !keyword.equals(keyword.strip()) || keyword.contains("  ");
      if (keyword.isEmpty() || keyword.length() > 79 || !printable || spaced) {
        throw new IllegalArgumentException(
            "metadata: expected keywords of 1 to 79 printable ASCII characters, found \""
                + keyword
                + "\"");
      }
      if (ExrWriter.RESERVED.contains(keyword)) {
        throw new IllegalArgumentException("metadata: OpenEXR reserves the keyword " + keyword);
      }
    }
  }

  /**
   * Writes a picture with {@link Options#DEFAULT}; see {@link #write(Image, Path, Options)}. The
   * exposure and tone curve in a scene's settings are not applied; pass them as options.
   */
  public static void write(Image image, Path file) throws IOException {
    write(image, file, Options.DEFAULT);
  }

  /**
   * Writes a picture. An existing file is replaced once the new one is complete.
   *
   * @throws IllegalArgumentException if the file name extension is unknown
   * @throws IOException if the file cannot be written; an existing file is then unchanged
   */
  public static void write(Image image, Path file, Options options) throws IOException {
    requireFormat(file);
    try (OutputFile output = OutputFile.open(file)) {
      write(image, output, options);
    }
  }

  /**
   * Writes a picture to a reserved file and commits it.
   *
   * @throws IllegalArgumentException if the file name extension is unknown
   * @throws IOException if the file cannot be written; it then stays reserved, and the caller may
   *     try again
   */
  @SuppressWarnings("exports") // internal
  public static void write(Image image, OutputFile output, Options options) throws IOException {
    write(image, List.of(), output, options);
  }

  /**
   * Writes a picture with layers to a reserved OpenEXR file and commits it. Layers are not
   * multiplied by alpha.
   *
   * @param layers of the picture's size, with different names; none for other formats
   * @throws IllegalArgumentException if the file name extension is unknown, if a format without
   *     layers has some, or if a layer has another size or a name that occurs twice
   * @throws IOException if the file cannot be written; it then stays reserved, and the caller may
   *     try again
   */
  @SuppressWarnings("exports") // internal
  public static void write(Image image, List<ImageLayer> layers, OutputFile output, Options options)
      throws IOException {
    ImageFormat format = requireFormat(output.target());
    encode(image, layers, format, options, output.restart());
    output.commit();
  }

  /**
   * Writes a picture with layers to an OpenEXR file, which is replaced if it exists; see {@link
   * #write(Image, Path, Options)}.
   *
   * @param layers of the picture's size, with different names
   */
  public static void write(Image image, List<ImageLayer> layers, Path file, Options options)
      throws IOException {
    requireFormat(file);
    try (OutputFile output = OutputFile.open(file)) {
      write(image, layers, output, options);
    }
  }

  /**
   * Writes a layer as PNG without a tone curve: values from {@code low} to {@code high} become 0 to
   * 2^bits - 1. One channel is gray; two or three are red, green and blue.
   *
   * @param low value that becomes 0, as all smaller ones and NaN do
   * @param high more than {@code low}
   * @param bits bits per channel, 8 or 16
   * @param texts metadata by keyword; see {@link Options#metadata}
   * @throws IOException if the file cannot be written
   */
  @SuppressWarnings("exports") // internal
  public static void writeLinear(
      ImageLayer layer,
      double low,
      double high,
      int bits,
      Map<String, String> texts,
      OutputFile output)
      throws IOException {
    if (layer.channels().size() > 3 || !(high > low) || bits != 8 && bits != 16) {
      throw new IllegalArgumentException(
          "expected at most 3 channels, low < high, and 8 or 16 bits, found %d, %s, %s, %d"
              .formatted(layer.channels().size(), low, high, bits));
    }
    OutputStream out =
        new BufferedOutputStream(Channels.newOutputStream(output.restart()), BUFFER_BYTES);
    PngWriter.writeLinear(layer, low, high, bits, texts, out);
    out.flush();
    output.commit();
  }

  /** Writes a picture to a channel at position 0 and leaves the channel open. */
  static void encode(Image image, ImageFormat format, Options options, SeekableByteChannel channel)
      throws IOException {
    encode(image, List.of(), format, options, channel);
  }

  private static void encode(
      Image image,
      List<ImageLayer> layers,
      ImageFormat format,
      Options options,
      SeekableByteChannel channel)
      throws IOException {
    if (!layers.isEmpty() && format != ImageFormat.EXR) {
      throw new IllegalArgumentException("layers: expected an .exr file, found " + format.ending());
    }
    Objects.requireNonNull(image, "image");
    Objects.requireNonNull(options, "options");
    OutputStream out = new BufferedOutputStream(Channels.newOutputStream(channel), BUFFER_BYTES);
    switch (format) {
      case PNG -> PngWriter.write(image, options, out);
      case JPG -> JpegWriter.write(image, options, out);
      case PFM -> PfmWriter.write(image, out);
      case EXR -> ExrWriter.write(image, layers, options.metadata(), channel);
    }
    out.flush();
  }

  /** Returns a finite value: infinities become ±{@link Float#MAX_VALUE}, and NaN becomes 0. */
  static float finite(float v) {
    return Float.isNaN(v) ? 0 : Math.max(-Float.MAX_VALUE, Math.min(v, Float.MAX_VALUE));
  }

  private static ImageFormat requireFormat(Path file) {
    return ImageFormat.of(file)
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    file + ": expected a name that ends in one of " + ImageFormat.endings()));
  }
}
