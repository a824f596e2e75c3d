package io.github.lumbre.image;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.SeekableByteChannel;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Map;
import java.util.Set;
import java.util.zip.Deflater;

/**
 * Writes OpenEXR files: one part, scan lines, float channels, ZIP compression in blocks of 16 lines
 * ("OpenEXR File Layout" and "Technical Introduction to OpenEXR", openexr.com).
 */
final class ExrWriter {
  /**
   * Reserved names, which metadata cannot use: the attributes that every file has, and those of
   * multi-part or tiled files, which readers interpret in any file.
   */
  static final Set<String> RESERVED =
      Set.of(
          "channels",
          "chunkCount",
          "compression",
          "dataWindow",
          "displayWindow",
          "lineOrder",
          "pixelAspectRatio",
          "screenWindowCenter",
          "screenWindowWidth",
          "tiles",
          "type",
          "version");

  private static final int MAGIC = 20000630;
  private static final int VERSION = 2;
  private static final int LONG_NAMES = 0x400;
  private static final int SHORT_NAME = 31;
  private static final int FLOAT = 2;
  private static final int ZIP = 3;
  private static final int BLOCK_LINES = 16;

  /** OpenEXR's own default: files nearly as small as at the best level, and much faster. */
  private static final int DEFLATE_LEVEL = 4;

  private final Image image;
  private final SeekableByteChannel channel;
  private final int channels;

  private ExrWriter(Image image, SeekableByteChannel channel) {
    this.image = image;
    this.channel = channel;
    this.channels = image.hasAlpha() ? 4 : 3;
  }

  /**
   * Writes a picture to an empty channel. Colors are multiplied by alpha; metadata become string
   * attributes in UTF-8.
   */
  static void write(Image image, Map<String, String> metadata, SeekableByteChannel channel)
      throws IOException {
    new ExrWriter(image, channel).write(metadata);
  }

  private void write(Map<String, String> metadata) throws IOException {
    byte[] header = header(metadata);
    writeFully(ByteBuffer.wrap(header));
    int blocks = (image.height() + BLOCK_LINES - 1) / BLOCK_LINES;
    ByteBuffer offsets = littleEndian(8 * blocks);
    writeFully(offsets.duplicate());
    long position = header.length + 8L * blocks;
    Deflater deflater = new Deflater(DEFLATE_LEVEL);
    try {
      for (int y = 0; y < image.height(); y += BLOCK_LINES) {
        offsets.putLong(position);
        byte[] data = packed(lines(y), deflater);
        ByteBuffer start = littleEndian(8).putInt(y).putInt(data.length).flip();
        writeFully(start);
        writeFully(ByteBuffer.wrap(data));
        position += 8L + data.length;
      }
    } finally {
      deflater.end();
    }
    // Fill in the offset table, now that the block sizes are known.
    channel.position(header.length);
    writeFully(offsets.flip());
  }

  private byte[] header(Map<String, String> metadata) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    boolean longNames = metadata.keySet().stream().anyMatch(k -> k.length() > SHORT_NAME);
    out.writeBytes(ints(MAGIC, VERSION | (longNames ? LONG_NAMES : 0)));
    byte[] window = ints(0, 0, image.width() - 1, image.height() - 1);
    attribute(out, "channels", "chlist", channelList());
    attribute(out, "compression", "compression", new byte[] {ZIP});
    attribute(out, "dataWindow", "box2i", window);
    attribute(out, "displayWindow", "box2i", window);
    attribute(out, "lineOrder", "lineOrder", new byte[] {0});
    attribute(out, "pixelAspectRatio", "float", ints(Float.floatToIntBits(1)));
    attribute(out, "screenWindowCenter", "v2f", ints(0, 0));
    attribute(out, "screenWindowWidth", "float", ints(Float.floatToIntBits(1)));
    metadata.forEach(
        (keyword, text) ->
            attribute(out, keyword, "string", text.getBytes(StandardCharsets.UTF_8)));
    out.write(0);
    return out.toByteArray();
  }

  private byte[] channelList() {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    for (String name : (channels == 4 ? "A B G R" : "B G R").split(" ")) {
      text(out, name);
      // Pixel type, not perceptually linear, no subsampling.
      out.writeBytes(ints(FLOAT, 0, 1, 1));
    }
    out.write(0);
    return out.toByteArray();
  }

  private static void attribute(ByteArrayOutputStream out, String name, String type, byte[] value) {
    text(out, name);
    text(out, type);
    out.writeBytes(ints(value.length));
    out.writeBytes(value);
  }

  private static void text(ByteArrayOutputStream out, String ascii) {
    out.writeBytes(ascii.getBytes(StandardCharsets.US_ASCII));
    out.write(0);
  }

  private static byte[] ints(int... values) {
    ByteBuffer buffer = littleEndian(4 * values.length);
    for (int value : values) {
      buffer.putInt(value);
    }
    return buffer.array();
  }

  /** Returns the bytes of up to 16 lines. Each line holds one channel after the other. */
  private byte[] lines(int first) {
    int last = Math.min(first + BLOCK_LINES, image.height());
    ByteBuffer raw = littleEndian(4 * channels * image.width() * (last - first));
    for (int y = first; y < last; y++) {
      if (channels == 4) {
        for (int x = 0; x < image.width(); x++) {
          raw.putFloat(ImageWriter.finite(image.alpha(x, y)));
        }
      }
      for (int component = 2; component >= 0; component--) {
        for (int x = 0; x < image.width(); x++) {
          float value = ImageWriter.finite(image.rgb()[3 * (y * image.width() + x) + component]);
          raw.putFloat(ImageWriter.finite(value * image.alpha(x, y)));
        }
      }
    }
    return raw.array();
  }

  /** Returns a compressed block, or the raw block if compression would not shrink it. */
  private static byte[] packed(byte[] raw, Deflater deflater) {
    deflater.reset();
    deflater.setInput(predicted(raw));
    deflater.finish();
    byte[] packed = new byte[raw.length];
    int length = deflater.deflate(packed);
    return deflater.finished() && length < raw.length ? Arrays.copyOf(packed, length) : raw;
  }

  /**
   * Returns the bytes at even positions, then those at odd positions, each as its difference from
   * the previous one plus 128.
   */
  private static byte[] predicted(byte[] raw) {
    byte[] split = new byte[raw.length];
    int half = (raw.length + 1) / 2;
    for (int i = 0; i < raw.length; i++) {
      split[(i & 1) == 0 ? i / 2 : half + i / 2] = raw[i];
    }
    for (int i = raw.length - 1; i > 0; i--) {
      split[i] = (byte) (split[i] - split[i - 1] + 128);
    }
    return split;
  }

  private static ByteBuffer littleEndian(int bytes) {
    return ByteBuffer.allocate(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  private void writeFully(ByteBuffer buffer) throws IOException {
    while (buffer.hasRemaining()) {
      channel.write(buffer);
    }
  }
}
