package io.github.lumbre.image;

import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.image.format.exr.ExrWriter;
import io.github.lumbre.image.internal.CssColor;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.image.internal.PictureEncoder;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

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
   * @param background linear color, each component in [0,1], behind a picture with alpha, which is
   *     written without alpha then. PNG and JPEG show its sRGB values, whatever exposure and tone
   *     curve are: both are applied to the picture alone. PFM and OpenEXR have its light. Empty to
   *     keep alpha
   * @param dither of the colors of an 8-bit PNG; empty to round them, as frames that are compressed
   *     against each other need it
   */
  public record Options(
      Exposure exposure,
      ToneCurve curve,
      int pngBits,
      int jpegQuality,
      Map<String, String> metadata,
      Optional<Rgb> background,
      Optional<Dither> dither) {
    /** The default quality of a JPEG. */
    public static final int DEFAULT_JPEG_QUALITY = 90;

    /** The defaults: no exposure, the sRGB curve, 8 bits, dithered, no metadata. */
    public static final Options DEFAULT = new Options(Exposure.NONE, ToneCurve.SRGB, 8, Map.of());

    /** The defaults without dithering, for pictures of measured values. */
    public static final Options ROUNDED = DEFAULT.withDither(Optional.empty());

    /** Creates options with {@link #DEFAULT_JPEG_QUALITY}. */
    public Options(Exposure exposure, ToneCurve curve, int pngBits, Map<String, String> metadata) {
      this(exposure, curve, pngBits, DEFAULT_JPEG_QUALITY, metadata);
    }

    /** Creates options that keep alpha, for a full frame. */
    public Options(
        Exposure exposure,
        ToneCurve curve,
        int pngBits,
        int jpegQuality,
        Map<String, String> metadata) {
      this(
          exposure,
          curve,
          pngBits,
          jpegQuality,
          metadata,
          Optional.empty(),
          Optional.of(Dither.FULL_FRAME));
    }

    /**
     * @throws IllegalArgumentException if a number, keyword or color is invalid
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
      if (!background.map(CssColor::isOnScreen).orElse(true)) {
        throw new IllegalArgumentException(
            "background: expected components from 0 to 1, found " + background.get());
      }
    }

    /** Returns these options with other metadata. */
    public Options withMetadata(Map<String, String> other) {
      return new Options(exposure, curve, pngBits, jpegQuality, other, background, dither);
    }

    /** Returns these options with another background. */
    public Options withBackground(Optional<Rgb> other) {
      return new Options(exposure, curve, pngBits, jpegQuality, metadata, other, dither);
    }

    /** Returns these options with another dithering, or without one. */
    public Options withDither(Optional<Dither> other) {
      return new Options(exposure, curve, pngBits, jpegQuality, metadata, background, other);
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
    write(image, List.of(), file, options);
  }

  /**
   * Writes a picture with layers to an OpenEXR file, which is replaced if it exists; see {@link
   * #write(Image, Path, Options)}.
   *
   * @param layers of the picture's size, with different names
   */
  public static void write(Image image, List<ImageLayer> layers, Path file, Options options)
      throws IOException {
    ImageFormat.require(file);
    try (OutputFile output = OutputFile.open(file)) {
      PictureEncoder.write(image, layers, output, options);
    }
  }
}
