package io.github.lumbre.image.format.exr;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.internal.LinearPicture;
import io.github.lumbre.image.internal.PictureEncoder;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.SeekableByteChannel;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import java.util.zip.Deflater;

/**
 * Writes OpenEXR files: one part, scan lines, float and half channels, ZIP compression in blocks of
 * 16 lines ("OpenEXR File Layout" and "Technical Introduction to OpenEXR", openexr.com).
 */
public final class ExrWriter {
  /**
   * Reserved names, which metadata cannot use: the attributes that every file has, and the
   * attributes of multi-part or tiled files, which readers interpret in any file.
   */
  public static final Set<String> RESERVED =
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
  private static final int ZIP = 3;
  private static final int BLOCK_LINES = 16;

  /** OpenEXR's own default: files nearly as small as at the best level, and much faster. */
  private static final int DEFLATE_LEVEL = 4;

  private final Image image;
  private final SeekableByteChannel file;
  private final List<Channel> channels;

  @FunctionalInterface
  private interface Values {
    float at(int x, int y);
  }

  /** A channel with its full name. */
  private record Channel(String name, ExrChannel.Type type, Values values) {}

  private ExrWriter(Image image, List<ImageLayer> layers, SeekableByteChannel file) {
    this.image = image;
    this.file = file;
    channels = new ArrayList<>();
    addPicture();
    layers.forEach(this::add);
    channels.sort(Comparator.comparing(channel -> utf8(channel.name), Arrays::compareUnsigned));
    for (int i = 1; i < channels.size(); i++) {
      if (channels.get(i).name.equals(channels.get(i - 1).name)) {
        throw new IllegalArgumentException(
            "layers: expected different channels, found " + channels.get(i).name + " twice");
      }
    }
  }

  private void addPicture() {
    List<String> names = List.of("R", "G", "B");
    for (int component = 0; component < 3; component++) {
      int c = component;
      Values values = (x, y) -> image.associated(x, y, c);
      channels.add(new Channel(names.get(c), ExrChannel.Type.FLOAT, values));
    }
    if (image.hasAlpha()) {
      channels.add(new Channel("A", ExrChannel.Type.FLOAT, image::alpha));
    }
  }

  private void add(ImageLayer layer) {
    if (layer.width() != image.width() || layer.height() != image.height()) {
      throw new IllegalArgumentException(
          "layers: expected %dx%d pixels, found %dx%d in %s"
              .formatted(
                  image.width(), image.height(), layer.width(), layer.height(), layer.name()));
    }
    boolean isHalf = layer.precision() == ImageLayer.Precision.HALF;
    for (int i = 0; i < layer.channels().size(); i++) {
      String prefix = layer.name().isEmpty() ? "" : layer.name() + ".";
      int offset = i;
      int stride = layer.channels().size();
      channels.add(
          new Channel(
              prefix + layer.channels().get(i),
              isHalf ? ExrChannel.Type.HALF : ExrChannel.Type.FLOAT,
              (x, y) -> layer.values()[(y * layer.width() + x) * stride + offset]));
    }
  }

  /**
   * Writes a picture and its layers to an empty channel. Colors of the picture are multiplied by
   * alpha, where that is not 0, so that {@link LinearPicture#straight} returns them; names and
   * metadata are in UTF-8.
   */
  public static void write(
      Image image, List<ImageLayer> layers, Map<String, String> metadata, SeekableByteChannel file)
      throws IOException {
    new ExrWriter(image, layers, file).write(metadata);
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
    file.position(header.length);
    writeFully(offsets.flip());
  }

  private byte[] header(Map<String, String> metadata) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    boolean longNames =
        Stream.concat(metadata.keySet().stream(), channels.stream().map(Channel::name))
            .anyMatch(name -> utf8(name).length > SHORT_NAME);
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
    metadata.forEach((keyword, text) -> attribute(out, keyword, "string", utf8(text)));
    out.write(0);
    return out.toByteArray();
  }

  private byte[] channelList() {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    for (Channel channel : channels) {
      text(out, channel.name);
      // Pixel type, not perceptually linear, no subsampling.
      out.writeBytes(ints(channel.type.ordinal(), 0, 1, 1));
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

  private static void text(ByteArrayOutputStream out, String text) {
    out.writeBytes(utf8(text));
    out.write(0);
  }

  private static byte[] utf8(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
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
    int pixelBytes = channels.stream().mapToInt(channel -> channel.type.bytes()).sum();
    ByteBuffer raw = littleEndian(Math.multiplyExact(pixelBytes, image.width() * (last - first)));
    for (int y = first; y < last; y++) {
      for (Channel channel : channels) {
        for (int x = 0; x < image.width(); x++) {
          float value = PictureEncoder.finite(channel.values.at(x, y));
          if (channel.type == ExrChannel.Type.HALF) {
            raw.putShort(ExrChannel.toHalf(value));
          } else {
            raw.putFloat(value);
          }
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
      file.write(buffer);
    }
  }
}
