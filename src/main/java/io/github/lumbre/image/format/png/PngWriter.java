package io.github.lumbre.image.format.png;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.internal.DisplayRows;
import io.github.lumbre.image.internal.SampleRows;
import io.github.lumbre.image.internal.Srgb;
import java.io.BufferedOutputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Map;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

/**
 * Writes PNG files (PNG specification, third edition): 8 or 16 bits, straight alpha if the picture
 * has any, metadata as text chunks. Java's own writer loads hundreds of classes and copies the
 * picture.
 */
public final class PngWriter {
  static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', 0x0d, 0x0a, 0x1a, 0x0a};
  private static final int GRAY = 0;
  private static final int RGB = 2;
  private static final int RGBA = 6;

  /** The gamma 1 / 2.2, times 100,000. */
  private static final int GAMMA = 45455;

  /** zlib's level: with lower ones, dithered pictures are 6 % larger. */
  private static final int LEVEL = 6;

  /** The number of bytes in a data chunk. */
  private static final int CHUNK = 1 << 15;

  private PngWriter() {}

  /** Writes a picture with exposure and tone curve applied. */
  public static void write(Image image, ImageWriter.Options options, OutputStream out)
      throws IOException {
    SampleRows rows = DisplayRows.of(image, options, options.pngBits(), image.hasAlpha());
    writeHeader(rows, out);
    if (options.curve().endsInSrgb()) {
      writeChunk("sRGB", new byte[] {0}, 1, out);
    } else {
      writeChunk("gAMA", bytes(GAMMA), Integer.BYTES, out);
    }
    writeRest(rows, options.metadata(), out);
  }

  /**
   * Writes a layer without a tone curve: gray for one channel, RGB for two or three.
   *
   * @param low value that becomes 0, as all smaller ones do
   * @param high value that becomes the largest number, as all larger ones do; more than {@code low}
   * @param bits bits per channel, 8 or 16
   * @param texts metadata by keyword
   */
  public static void writeLinear(
      ImageLayer layer,
      double low,
      double high,
      int bits,
      Map<String, String> texts,
      OutputStream out)
      throws IOException {
    SampleRows rows = new LinearRows(layer, low, high, bits);
    writeHeader(rows, out);
    writeRest(rows, texts, out);
  }

  /** Writes encoded values as they are: RGB, or RGB and alpha. */
  public static void write(Pixels pixels, OutputStream out) throws IOException {
    SampleRows rows = new PixelRows(pixels);
    writeHeader(rows, out);
    writeRest(rows, Map.of(), out);
  }

  /** The rows of encoded values. */
  private record PixelRows(Pixels pixels) implements SampleRows {
    @Override
    public int width() {
      return pixels.width();
    }

    @Override
    public int height() {
      return pixels.height();
    }

    @Override
    public int bands() {
      return pixels.hasAlpha() ? 4 : 3;
    }

    @Override
    public int bits() {
      return pixels.max() == 0xff ? 8 : 16;
    }

    @Override
    public void read(int y, int[] row) {
      int bands = bands();
      for (int i = 0; i < row.length; i++) {
        int x = i / bands;
        row[i] = i % bands == 3 ? pixels.alpha(x, y) : pixels.raw(x, y, i % bands);
      }
    }
  }

  /** The rows of a layer between two values. */
  private record LinearRows(ImageLayer layer, double low, double high, int bits)
      implements SampleRows {
    @Override
    public int width() {
      return layer.width();
    }

    @Override
    public int height() {
      return layer.height();
    }

    @Override
    public int bands() {
      return layer.channels().size() == 1 ? 1 : 3;
    }

    @Override
    public void read(int y, int[] row) {
      int bands = bands();
      int max = (1 << bits) - 1;
      for (int i = 0; i < row.length; i++) {
        boolean exists = i % bands < layer.channels().size();
        double value = exists ? layer.value(i / bands, y, i % bands) : low;
        // NaN becomes 0.
        row[i] = (int) Math.round(max * Srgb.clamp((value - low) / (high - low)));
      }
    }
  }

  private static void writeHeader(SampleRows rows, OutputStream out) throws IOException {
    out.write(SIGNATURE);
    ByteArrayOutputStream header = new ByteArrayOutputStream();
    DataOutputStream data = new DataOutputStream(header);
    data.writeInt(rows.width());
    data.writeInt(rows.height());
    data.writeByte(rows.bits());
    data.writeByte(rows.bands() == 1 ? GRAY : rows.bands() == 3 ? RGB : RGBA);
    // The only kinds of compression and filters, and no interlacing.
    data.write(new byte[3]);
    writeChunk("IHDR", header, out);
  }

  private static void writeRest(SampleRows rows, Map<String, String> texts, OutputStream out)
      throws IOException {
    for (Map.Entry<String, String> text : texts.entrySet()) {
      writeText(text.getKey(), text.getValue(), out);
    }
    Deflater deflater = new Deflater(LEVEL);
    try {
      DeflaterOutputStream deflated =
          new DeflaterOutputStream(
              new BufferedOutputStream(new DataChunks(out), CHUNK), deflater, CHUNK);
      writeRows(rows, deflated);
      deflated.finish();
      deflated.flush();
    } finally {
      deflater.end();
    }
    writeChunk("IEND", new byte[0], 0, out);
  }

  private static void writeRows(SampleRows rows, OutputStream out) throws IOException {
    int bytesPerValue = rows.bits() / 8;
    int[] values = new int[Math.multiplyExact(rows.bands(), rows.width())];
    PngFilter filter = new PngFilter(rows.bands() * bytesPerValue, values.length * bytesPerValue);
    for (int y = 0; y < rows.height(); y++) {
      rows.read(y, values);
      byte[] row = filter.nextRow();
      int i = filter.start();
      for (int value : values) {
        if (bytesPerValue == 2) {
          row[i++] = (byte) (value >> 8);
        }
        row[i++] = (byte) value;
      }
      filter.write(out);
    }
  }

  static void writeText(String keyword, String text, OutputStream out) throws IOException {
    ByteArrayOutputStream chunk = new ByteArrayOutputStream();
    chunk.writeBytes(keyword.getBytes(StandardCharsets.ISO_8859_1));
    chunk.write(0);
    if (isLatin(text)) {
      chunk.writeBytes(text.getBytes(StandardCharsets.ISO_8859_1));
      writeChunk("tEXt", chunk, out);
      return;
    }
    // Not compressed, without a language and a translated keyword.
    chunk.writeBytes(new byte[4]);
    // A NUL character would end the text.
    chunk.writeBytes(text.replace('\0', '\uFFFD').getBytes(StandardCharsets.UTF_8));
    writeChunk("iTXt", chunk, out);
  }

  /**
   * Returns whether a text consists of printable Latin-1 characters and line feeds, as a tEXt chunk
   * requires.
   */
  private static boolean isLatin(String text) {
    return text.chars()
        .allMatch(c -> c == '\n' || (c >= 0x20 && c <= 0x7e) || (c >= 0xa1 && c <= 0xff));
  }

  private static void writeChunk(String type, ByteArrayOutputStream data, OutputStream out)
      throws IOException {
    writeChunk(type, data.toByteArray(), data.size(), out);
  }

  static void writeChunk(String type, byte[] data, int length, OutputStream out)
      throws IOException {
    byte[] name = type.getBytes(StandardCharsets.US_ASCII);
    CRC32 sum = new CRC32();
    sum.update(name);
    sum.update(data, 0, length);
    out.write(bytes(length));
    out.write(name);
    out.write(data, 0, length);
    out.write(bytes((int) sum.getValue()));
  }

  static byte[] bytes(int value) {
    return new byte[] {
      (byte) (value >> 24), (byte) (value >> 16), (byte) (value >> 8), (byte) value
    };
  }

  /** Writes each block of bytes as a data chunk. */
  private static final class DataChunks extends OutputStream {
    private final OutputStream out;

    DataChunks(OutputStream out) {
      this.out = out;
    }

    @Override
    public void write(int value) throws IOException {
      write(new byte[] {(byte) value}, 0, 1);
    }

    @Override
    public void write(byte[] data, int offset, int length) throws IOException {
      byte[] block = offset == 0 ? data : Arrays.copyOfRange(data, offset, offset + length);
      writeChunk("IDAT", block, length, out);
    }
  }
}
