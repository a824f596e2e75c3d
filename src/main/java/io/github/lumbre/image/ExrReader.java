package io.github.lumbre.image;

import static io.github.lumbre.image.ImageFormatException.malformed;

import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/**
 * Reads OpenEXR files of the kind that {@link ExrWriter} writes: one part, scan lines, 32-bit float
 * channels R, G, B and optionally A, uncompressed or compressed by ZIP ("OpenEXR File Layout",
 * openexr.com). Colors are divided by alpha, because the alpha of an {@link Image} is straight.
 */
final class ExrReader {
  private static final int MAGIC = 20000630;
  private static final int VERSION = 2;
  private static final int LONG_NAMES = 0x400;
  private static final int FLOAT = 2;
  private static final String ORDER = "RGBA";

  /**
   * The largest number of bytes that one byte of deflated data can inflate to (zlib technical
   * notes).
   */
  private static final long MAX_INFLATION = 1032;

  private final ByteBuffer in;
  private final Map<String, ByteBuffer> attributes = new HashMap<>();
  private int width;
  private int height;

  /** The channels in file order, each as its index in RGBA. */
  private final List<Integer> channels = new ArrayList<>();

  private ExrReader(byte[] file) {
    in = little(file);
  }

  static boolean startsIn(byte[] file) {
    return file.length >= Long.BYTES && little(file).getInt() == MAGIC;
  }

  /** Reads a file that {@link #startsIn} recognizes. */
  static Image read(byte[] file) throws ImageFormatException {
    try {
      ExrReader reader = new ExrReader(file);
      reader.readHeader();
      return reader.readPixels();
    } catch (BufferUnderflowException | IndexOutOfBoundsException | IllegalArgumentException e) {
      throw malformed("OpenEXR is damaged or ends too early");
    } catch (DataFormatException e) {
      throw malformed("OpenEXR is damaged: a block cannot be unpacked");
    }
  }

  private void readHeader() throws ImageFormatException {
    in.getInt();
    if ((in.getInt() & ~LONG_NAMES) != VERSION) {
      throw malformed("OpenEXR: expected version 2, one part, scan lines");
    }
    for (String name = text(in); !name.isEmpty(); name = text(in)) {
      text(in);
      int length = in.getInt();
      if (length < 0 || length > in.remaining()) {
        throw malformed("OpenEXR ends too early");
      }
      attributes.put(name, in.slice(in.position(), length).order(ByteOrder.LITTLE_ENDIAN));
      in.position(in.position() + length);
    }
    ByteBuffer window = attribute("dataWindow");
    width = side(window.getInt(0), window.getInt(8));
    height = side(window.getInt(4), window.getInt(12));
    ImageReader.checkSize(width, height);
    readChannels(attribute("channels"));
  }

  /** Returns the number of pixels from the first to the last, at most {@link Integer#MAX_VALUE}. */
  private static int side(int first, int last) throws ImageFormatException {
    if (last < first) {
      throw malformed("OpenEXR: the data window ends before it begins");
    }
    return (int) Math.min((long) last - first + 1, Integer.MAX_VALUE);
  }

  private void readChannels(ByteBuffer list) throws ImageFormatException {
    for (String name = text(list); !name.isEmpty(); name = text(list)) {
      int type = list.getInt();
      list.getInt();
      boolean whole = list.getInt() == 1 && list.getInt() == 1;
      if (name.length() != 1 || ORDER.indexOf(name) < 0 || type != FLOAT || !whole) {
        throw malformed("OpenEXR: expected float channels R, G, B and A");
      }
      channels.add(ORDER.indexOf(name));
    }
    if (channels.stream().distinct().count() != channels.size()
        || !channels.containsAll(List.of(0, 1, 2))) {
      throw malformed("OpenEXR: expected the channels R, G and B");
    }
  }

  private ByteBuffer attribute(String name) throws ImageFormatException {
    ByteBuffer value = attributes.get(name);
    if (value == null) {
      throw malformed("OpenEXR has no attribute " + name);
    }
    return value;
  }

  private Image readPixels() throws ImageFormatException, DataFormatException {
    int lines =
        switch (attribute("compression").get(0)) {
          case 0, 2 -> 1;
          case 3 -> 16;
          default -> throw malformed("OpenEXR: expected no compression or ZIP");
        };
    boolean packed = attribute("compression").get(0) != 0;
    int blocks = (height + lines - 1) / lines;
    long bytes = (long) width * height * channels.size() * Float.BYTES;
    if (in.remaining() < (long) Long.BYTES * blocks || bytes > MAX_INFLATION * in.remaining()) {
      throw malformed("OpenEXR ends too early");
    }
    float[] rgb = LinearReader.raster(width, height, 3);
    float[] alpha = channels.contains(3) ? LinearReader.raster(width, height, 1) : new float[0];
    BitSet found = new BitSet(blocks);
    int top = attribute("dataWindow").getInt(4);
    // The offset table is not needed: each block states its lines.
    in.position(in.position() + Long.BYTES * blocks);
    for (int i = 0; i < blocks; i++) {
      int first = Objects.checkIndex(in.getInt() - top, height);
      if (first % lines != 0 || found.get(first / lines)) {
        throw malformed("OpenEXR is damaged: expected one block for every " + lines + " lines");
      }
      found.set(first / lines);
      byte[] data = new byte[Math.max(0, Math.min(in.getInt(), in.remaining()))];
      in.get(data);
      int rows = Math.min(lines, height - first);
      if (!packed && data.length != bytes(rows)) {
        throw malformed("OpenEXR is damaged: a block is too short or too long");
      }
      byte[] raw = packed ? unpacked(data, bytes(rows)) : data;
      put(little(raw), first, rows, rgb, alpha);
    }
    divide(rgb, alpha);
    return new Image(width, height, rgb, alpha);
  }

  private int bytes(int rows) {
    return Float.BYTES * channels.size() * width * rows;
  }

  private void put(ByteBuffer raw, int first, int rows, float[] rgb, float[] alpha) {
    for (int y = first; y < first + rows; y++) {
      for (int channel : channels) {
        for (int i = y * width; i < (y + 1) * width; i++) {
          if (channel == 3) {
            alpha[i] = raw.getFloat();
          } else {
            rgb[3 * i + channel] = raw.getFloat();
          }
        }
      }
    }
  }

  private static void divide(float[] rgb, float[] alpha) throws ImageFormatException {
    for (int i = 0; i < 3 * alpha.length; i++) {
      float opacity = alpha[i / 3];
      if (!(opacity >= 0 && opacity <= 1)) {
        throw malformed("OpenEXR: expected alpha of 0 to 1, found " + opacity);
      }
      rgb[i] = opacity > 0 ? rgb[i] / opacity : 0;
    }
  }

  /**
   * Reverses the compression of {@link ExrWriter}. Blocks that compression would not shrink are
   * stored raw.
   */
  private static byte[] unpacked(byte[] packed, int size)
      throws DataFormatException, ImageFormatException {
    if (packed.length == size) {
      return packed;
    }
    byte[] split = new byte[size];
    Inflater inflater = new Inflater();
    try {
      inflater.setInput(packed);
      boolean isAll = inflater.inflate(split) == size;
      if (!isAll || inflater.inflate(new byte[1]) != 0 || !inflater.finished()) {
        throw malformed("OpenEXR is damaged: a block is too short or too long");
      }
    } finally {
      inflater.end();
    }
    for (int i = 1; i < size; i++) {
      split[i] = (byte) (split[i - 1] + split[i] - 128);
    }
    byte[] raw = new byte[size];
    int half = (size + 1) / 2;
    for (int i = 0; i < size; i++) {
      raw[i] = split[(i & 1) == 0 ? i / 2 : half + i / 2];
    }
    return raw;
  }

  private static String text(ByteBuffer in) {
    int start = in.position();
    while (in.get() != 0) {
      // The name ends at the first zero.
    }
    byte[] name = new byte[in.position() - start - 1];
    in.get(start, name);
    return new String(name, StandardCharsets.US_ASCII);
  }

  private static ByteBuffer little(byte[] bytes) {
    return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }
}
