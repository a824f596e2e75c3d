package io.github.lumbre.image;

import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Map;
import javax.imageio.IIOException;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/**
 * Writes PNG files with exposure and tone curve applied: 8 or 16 bits, straight alpha if the
 * picture has any, metadata as text chunks. A quantized copy takes 3 to 8 bytes of memory per pixel
 * during writing.
 */
final class PngWriter {
  private static final String METADATA = "javax_imageio_png_1.0";

  private PngWriter() {}

  static void write(Image image, ImageWriter.Options options, OutputStream out) throws IOException {
    BufferedImage picture = quantised(image, options, options.pngBits(), image.hasAlpha());
    write(picture, chunks(options), out);
  }

  /** Writes a picture with the chunks of a metadata tree. */
  private static void write(BufferedImage picture, IIOMetadataNode chunks, OutputStream out)
      throws IOException {
    javax.imageio.ImageWriter writer = ImageIO.getImageWritersByFormatName("png").next();
    try (ImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
      writer.setOutput(stream);
      IIOMetadata metadata = writer.getDefaultImageMetadata(new ImageTypeSpecifier(picture), null);
      metadata.mergeTree(METADATA, chunks);
      writer.write(new IIOImage(picture, null, metadata));
    } catch (IIOException e) {
      // The exception's own message is empty; that of its cause is "No space left on device".
      throw e.getCause() instanceof IOException cause ? cause : e;
    } finally {
      writer.dispose();
    }
  }

  /**
   * Writes a layer without a tone curve: gray for one channel, RGB for two or three.
   *
   * @param low value that becomes 0, as all smaller ones do
   * @param high value that becomes the largest number, as all larger ones do; more than {@code low}
   * @param bits bits per channel, 8 or 16
   * @param texts metadata by keyword
   */
  static void writeLinear(
      ImageLayer layer,
      double low,
      double high,
      int bits,
      Map<String, String> texts,
      OutputStream out)
      throws IOException {
    int count = layer.channels().size();
    int bands = count == 1 ? 1 : 3;
    int type = bits == 8 ? DataBuffer.TYPE_BYTE : DataBuffer.TYPE_USHORT;
    WritableRaster raster =
        Raster.createInterleavedRaster(type, layer.width(), layer.height(), bands, null);
    int[] row = new int[bands * layer.width()];
    int max = (1 << bits) - 1;
    for (int y = 0; y < layer.height(); y++) {
      for (int i = 0; i < row.length; i++) {
        double value = i % bands < count ? layer.value(i / bands, y, i % bands) : low;
        // NaN becomes 0.
        row[i] = (int) Math.round(max * Srgb.clamp((value - low) / (high - low)));
      }
      raster.setPixels(0, y, layer.width(), 1, row);
    }
    int space = bands == 1 ? ColorSpace.CS_GRAY : ColorSpace.CS_sRGB;
    ColorModel model =
        new ComponentColorModel(
            ColorSpace.getInstance(space), false, false, Transparency.OPAQUE, type);
    IIOMetadataNode root = new IIOMetadataNode(METADATA);
    addTexts(root, texts);
    write(new BufferedImage(model, raster, false, null), root, out);
  }

  /**
   * Returns the picture quantized for display, with exposure and tone curve applied.
   *
   * @param bits bits per channel, 8 or 16
   * @param alpha whether to keep alpha; if not, the picture is composited over black
   */
  static BufferedImage quantised(
      Image image, ImageWriter.Options options, int bits, boolean alpha) {
    int type = bits == 8 ? DataBuffer.TYPE_BYTE : DataBuffer.TYPE_USHORT;
    int bands = alpha ? 4 : 3;
    WritableRaster raster =
        Raster.createInterleavedRaster(type, image.width(), image.height(), bands, null);
    fill(raster, image, options, (1 << bits) - 1);
    ColorModel model =
        new ComponentColorModel(
            ColorSpace.getInstance(ColorSpace.CS_sRGB),
            alpha,
            false,
            alpha ? Transparency.TRANSLUCENT : Transparency.OPAQUE,
            type);
    return new BufferedImage(model, raster, false, null);
  }

  private static void fill(
      WritableRaster raster, Image image, ImageWriter.Options options, int max) {
    // Keep the factor finite, so that black does not become NaN.
    double factor = Math.min(options.exposure().factor(image), Double.MAX_VALUE);
    int bands = raster.getNumBands();
    boolean isOverBlack = image.hasAlpha() && bands == 3;
    int[] row = new int[bands * image.width()];
    for (int y = 0; y < image.height(); y++) {
      for (int x = 0; x < image.width(); x++) {
        Rgb exposed = exposed(image.pixel(x, y), factor);
        Rgb light = isOverBlack ? exposed.times(Srgb.clamp(image.alpha(x, y))) : exposed;
        Rgb shown = options.curve().apply(light);
        int i = bands * x;
        row[i] = (int) Math.round(max * shown.r());
        row[i + 1] = (int) Math.round(max * shown.g());
        row[i + 2] = (int) Math.round(max * shown.b());
        if (bands == 4) {
          row[i + 3] = (int) Math.round(max * Srgb.clamp(image.alpha(x, y)));
        }
      }
      raster.setPixels(0, y, image.width(), 1, row);
    }
  }

  private static Rgb exposed(Rgb c, double factor) {
    return new Rgb(exposed(c.r(), factor), exposed(c.g(), factor), exposed(c.b(), factor));
  }

  private static double exposed(double v, double factor) {
    return v > 0 ? Math.min(v * factor, Double.MAX_VALUE) : 0;
  }

  private static IIOMetadataNode chunks(ImageWriter.Options options) {
    IIOMetadataNode root = new IIOMetadataNode(METADATA);
    if (options.curve().endsInSrgb()) {
      root.appendChild(node("sRGB", Map.of("renderingIntent", "Perceptual")));
    } else {
      root.appendChild(node("gAMA", Map.of("value", "45455")));
    }
    addTexts(root, options.metadata());
    return root;
  }

  private static void addTexts(IIOMetadataNode root, Map<String, String> texts) {
    IIOMetadataNode latin = new IIOMetadataNode("tEXt");
    IIOMetadataNode international = new IIOMetadataNode("iTXt");
    texts.forEach(
        (keyword, text) -> {
          if (isLatin(text)) {
            latin.appendChild(node("tEXtEntry", Map.of("keyword", keyword, "value", text)));
          } else {
            international.appendChild(internationalEntry(keyword, text));
          }
        });
    root.appendChild(latin);
    root.appendChild(international);
  }

  private static IIOMetadataNode internationalEntry(String keyword, String text) {
    return node(
        "iTXtEntry",
        Map.of(
            "keyword", keyword,
            "compressionFlag", "FALSE",
            "compressionMethod", "0",
            "languageTag", "",
            "translatedKeyword", "",
            // A NUL character would end the text.
            "text", text.replace('\0', '\uFFFD')));
  }

  private static IIOMetadataNode node(String name, Map<String, String> attributes) {
    IIOMetadataNode node = new IIOMetadataNode(name);
    attributes.forEach(node::setAttribute);
    return node;
  }

  /**
   * Returns whether a text consists of printable Latin-1 characters and line feeds, as a tEXt chunk
   * requires.
   */
  private static boolean isLatin(String text) {
    return text.chars()
        .allMatch(c -> c == '\n' || (c >= 0x20 && c <= 0x7e) || (c >= 0xa1 && c <= 0xff));
  }
}
