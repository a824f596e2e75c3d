package io.github.lumbre.image.internal;

import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.format.png.PngWriter;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.channels.SeekableByteChannel;
import java.util.List;
import java.util.Map;

/** Encodes pictures to files that are reserved; see {@link ImageWriter}. */
public final class PictureEncoder {
  private static final int BUFFER_BYTES = 1 << 16;

  private PictureEncoder() {}

  /**
   * Writes a picture to a reserved file and commits it.
   *
   * @throws IllegalArgumentException if the file name extension is unknown
   * @throws IOException if the file cannot be written; it then stays reserved, and the caller may
   *     try again
   */
  public static void write(Image image, OutputFile output, ImageWriter.Options options)
      throws IOException {
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
  public static void write(
      Image image, List<ImageLayer> layers, OutputFile output, ImageWriter.Options options)
      throws IOException {
    ImageFormat format = ImageFormat.require(output.target());
    format.write(image, layers, options, output.restart());
    output.commit();
  }

  /**
   * Writes a drawing to a reserved file and commits it.
   *
   * @throws IOException if the file cannot be written
   */
  public static void write(VectorPicture picture, OutputFile output) throws IOException {
    ImageFormat.SVG.write(picture, output.restart());
    output.commit();
  }

  /**
   * Writes a layer as PNG without a tone curve: values from {@code low} to {@code high} become 0 to
   * 2^bits - 1. One channel is gray; two or three are red, green and blue.
   *
   * @param low value that becomes 0, as all smaller ones and NaN do
   * @param high more than {@code low}
   * @param bits bits per channel, 8 or 16
   * @param texts metadata by keyword; see {@link ImageWriter.Options#metadata}
   * @throws IOException if the file cannot be written
   */
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
    OutputStream out = buffered(output.restart());
    PngWriter.writeLinear(layer, low, high, bits, texts, out);
    out.flush();
    output.commit();
  }

  static OutputStream buffered(SeekableByteChannel channel) {
    return new BufferedOutputStream(Channels.newOutputStream(channel), BUFFER_BYTES);
  }

  /** Returns a finite value: infinities become ±{@link Float#MAX_VALUE}, and NaN becomes 0. */
  public static float finite(float v) {
    return Float.isNaN(v) ? 0 : Math.max(-Float.MAX_VALUE, Math.min(v, Float.MAX_VALUE));
  }
}
