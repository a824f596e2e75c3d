package io.github.lumbre.image.format.exr;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.Deflater;

/**
 * Writes OpenEXR files in forms that the program does not write: RLE, ZIP, tiles, levels, parts,
 * numbers of all types. Mutable.
 */
public final class ExrBuilder {
  /** The value of a channel at a pixel. */
  @FunctionalInterface
  public interface Values {
    double at(int x, int y);
  }

  /** A channel. */
  private record Channel(int type, Values values) {}

  private static final int UINT = 0;
  private static final int HALF = 1;

  private final int width;
  private final int height;
  private final int compression;
  private final Map<String, Channel> channels = new TreeMap<>();
  private int tileWidth;
  private int tileHeight;
  private int levelMode;
  private int left;
  private int top;
  private byte[] display;
  private byte[] chromaticities = {};

  /**
   * @param compression 0 none, 1 RLE, 2 ZIPS, 3 ZIP
   */
  public ExrBuilder(int width, int height, int compression) {
    this.width = width;
    this.height = height;
    this.compression = compression;
    display = ints(0, 0, width - 1, height - 1);
  }

  /** Adds a channel. Values of halves must be powers of two or 0. */
  public ExrBuilder channel(String name, int type, Values values) {
    channels.put(name, new Channel(type, values));
    return this;
  }

  /**
   * Adds three float channels.
   *
   * @param prefix of their names
   */
  public ExrBuilder rgb(String prefix, Values values) {
    for (int i = 0; i < 3; i++) {
      int factor = 1 << i;
      channel(prefix + "RGB".charAt(i), 2, (x, y) -> factor * values.at(x, y));
    }
    return this;
  }

  /**
   * Uses tiles.
   *
   * @param mode 0 for one level, 1 for mipmaps; plus 16 to round sizes up
   */
  public ExrBuilder tiles(int newWidth, int newHeight, int mode) {
    tileWidth = newWidth;
    tileHeight = newHeight;
    levelMode = mode;
    return this;
  }

  /** Moves the data window, and shows other pixels than those of the file. */
  ExrBuilder windows(int newLeft, int newTop, int... newDisplay) {
    left = newLeft;
    top = newTop;
    display = ints(newDisplay);
    return this;
  }

  /** States the CIE x and y of red, green, blue and white. */
  ExrBuilder chromaticities(double... xy) {
    ByteBuffer value = little(Float.BYTES * xy.length);
    for (double each : xy) {
      value.putFloat((float) each);
    }
    chromaticities = value.array();
    return this;
  }

  public byte[] file() {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.writeBytes(ints(20000630, 2 | (tileWidth > 0 ? 0x200 : 0)));
    writeHeader(out, new byte[0]);
    ByteArrayOutputStream blocks = new ByteArrayOutputStream();
    int count = writeBlocks(blocks, new byte[0]);
    out.writeBytes(new byte[8 * count]);
    out.writeBytes(blocks.toByteArray());
    return out.toByteArray();
  }

  /** Returns a file with this part, another one of the same form, and its blocks before ours. */
  public byte[] fileBefore(ExrBuilder second) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.writeBytes(ints(20000630, 2 | 0x1000));
    byte[] type = (tileWidth > 0 ? "tiledimage" : "scanlineimage").getBytes(StandardCharsets.UTF_8);
    writeHeader(out, type);
    second.writeHeader(out, type);
    out.write(0);
    ByteArrayOutputStream ours = new ByteArrayOutputStream();
    int count = writeBlocks(ours, ints(0));
    ByteArrayOutputStream theirs = new ByteArrayOutputStream();
    int theirCount = second.writeBlocks(theirs, ints(1));
    long start = out.size() + 8L * (count + theirCount) + theirs.size();
    ByteBuffer table = little(8 * (count + theirCount));
    ByteBuffer block = ByteBuffer.wrap(ours.toByteArray()).order(ByteOrder.LITTLE_ENDIAN);
    int sizeAt = tileWidth > 0 ? 20 : 8;
    for (int i = 0, at = 0; i < count; i++) {
      table.putLong(start + at);
      at += sizeAt + 4 + block.getInt(at + sizeAt);
    }
    out.writeBytes(table.array());
    out.writeBytes(theirs.toByteArray());
    out.writeBytes(ours.toByteArray());
    return out.toByteArray();
  }

  private void writeHeader(ByteArrayOutputStream out, byte[] type) {
    ByteArrayOutputStream list = new ByteArrayOutputStream();
    channels.forEach(
        (name, channel) -> {
          text(list, name);
          list.writeBytes(ints(channel.type, 0, 1, 1));
        });
    list.write(0);
    byte[] window = ints(left, top, left + width - 1, top + height - 1);
    attribute(out, "channels", "chlist", list.toByteArray());
    if (chromaticities.length > 0) {
      attribute(out, "chromaticities", "chromaticities", chromaticities);
    }
    attribute(out, "compression", "compression", new byte[] {(byte) compression});
    attribute(out, "dataWindow", "box2i", window);
    attribute(out, "displayWindow", "box2i", display);
    attribute(out, "lineOrder", "lineOrder", new byte[1]);
    attribute(out, "pixelAspectRatio", "float", ints(Float.floatToIntBits(1)));
    attribute(out, "screenWindowCenter", "v2f", ints(0, 0));
    attribute(out, "screenWindowWidth", "float", ints(Float.floatToIntBits(1)));
    if (tileWidth > 0) {
      ByteBuffer tiles = little(9).putInt(tileWidth).putInt(tileHeight).put((byte) levelMode);
      attribute(out, "tiles", "tiledesc", tiles.array());
    }
    if (type.length > 0) {
      attribute(out, "type", "string", type);
    }
    out.write(0);
  }

  private int writeBlocks(ByteArrayOutputStream out, byte[] start) {
    if (tileWidth == 0) {
      int lines = compression == 3 ? 16 : 1;
      for (int y = 0; y < height; y += lines) {
        out.writeBytes(start);
        out.writeBytes(ints(top + y));
        writeBlock(out, 0, y, width, Math.min(lines, height - y), 0);
      }
      return (height + lines - 1) / lines;
    }
    int count = 0;
    int levels = (levelMode & 15) == 0 ? 1 : levels(Math.max(width, height));
    for (int level = levels - 1; level >= 0; level--) {
      int w = size(width, level);
      int h = size(height, level);
      for (int y = 0; y < h; y += tileHeight) {
        for (int x = 0; x < w; x += tileWidth) {
          out.writeBytes(start);
          out.writeBytes(ints(x / tileWidth, y / tileHeight, level, level));
          writeBlock(out, x, y, Math.min(tileWidth, w - x), Math.min(tileHeight, h - y), level);
          count++;
        }
      }
    }
    return count;
  }

  private int levels(int side) {
    int levels = 1;
    for (int rest = side; rest > 1; rest = levelMode >= 16 ? (rest + 1) / 2 : rest / 2) {
      levels++;
    }
    return levels;
  }

  private int size(int side, int level) {
    int rest = side;
    for (int i = 0; i < level; i++) {
      rest = Math.max(1, levelMode >= 16 ? (rest + 1) / 2 : rest / 2);
    }
    return rest;
  }

  private void writeBlock(ByteArrayOutputStream out, int left, int top, int w, int h, int level) {
    ByteBuffer raw = little(4 * channels.size() * w * h);
    for (int y = top; y < top + h; y++) {
      for (Channel channel : channels.values()) {
        for (int x = left; x < left + w; x++) {
          put(raw, channel.type, level == 0 ? channel.values.at(x, y) : -1);
        }
      }
    }
    byte[] bytes = Arrays.copyOf(raw.array(), raw.position());
    byte[] packed = packed(bytes);
    byte[] smaller = packed.length < bytes.length ? packed : bytes;
    out.writeBytes(ints(smaller.length));
    out.writeBytes(smaller);
  }

  private static void put(ByteBuffer raw, int type, double value) {
    if (type == UINT) {
      raw.putInt((int) (long) value);
    } else if (type == HALF) {
      int sign = value < 0 ? 0x8000 : 0;
      int magnitude = value == 0 ? 0 : Math.getExponent(value) + 15 << 10;
      raw.putShort((short) (sign | magnitude));
    } else {
      raw.putFloat((float) value);
    }
  }

  private byte[] packed(byte[] raw) {
    if (compression == 0) {
      return raw;
    }
    byte[] split = new byte[raw.length];
    int half = (raw.length + 1) / 2;
    for (int i = 0; i < raw.length; i++) {
      split[i % 2 == 0 ? i / 2 : half + i / 2] = raw[i];
    }
    for (int i = raw.length - 1; i > 0; i--) {
      split[i] = (byte) (split[i] - split[i - 1] + 128);
    }
    return compression == 1 ? runs(split) : deflated(split);
  }

  private static byte[] deflated(byte[] split) {
    Deflater deflater = new Deflater();
    deflater.setInput(split);
    deflater.finish();
    byte[] packed = new byte[2 * split.length + 64];
    int length = deflater.deflate(packed);
    deflater.end();
    return Arrays.copyOf(packed, length);
  }

  /** Returns runs of three and more equal bytes, and literal bytes one by one. */
  private static byte[] runs(byte[] split) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    for (int i = 0; i < split.length; ) {
      int end = i + 1;
      while (end < split.length && end - i < 128 && split[end] == split[i]) {
        end++;
      }
      if (end - i >= 3) {
        out.write(end - i - 1);
        out.write(split[i]);
        i = end;
      } else {
        out.write(-1);
        out.write(split[i++]);
      }
    }
    return out.toByteArray();
  }

  private static void attribute(ByteArrayOutputStream out, String name, String type, byte[] value) {
    text(out, name);
    text(out, type);
    out.writeBytes(ints(value.length));
    out.writeBytes(value);
  }

  private static void text(ByteArrayOutputStream out, String text) {
    out.writeBytes(text.getBytes(StandardCharsets.UTF_8));
    out.write(0);
  }

  private static byte[] ints(int... values) {
    ByteBuffer buffer = little(4 * values.length);
    for (int value : values) {
      buffer.putInt(value);
    }
    return buffer.array();
  }

  private static ByteBuffer little(int bytes) {
    return ByteBuffer.allocate(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }
}
