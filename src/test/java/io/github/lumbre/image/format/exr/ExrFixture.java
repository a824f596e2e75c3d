package io.github.lumbre.image.format.exr;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/**
 * A small reader of OpenEXR files, independent of the writer: ZIP compression, float channels.
 *
 * @param attributes the raw attribute values by name
 * @param types the attribute types by name
 * @param channels the rows of each channel by name, consecutively from the top
 */
record ExrFixture(
    int width,
    int height,
    int version,
    Map<String, byte[]> attributes,
    Map<String, String> types,
    Map<String, float[]> channels) {

  static ExrFixture read(byte[] file) throws DataFormatException {
    ByteBuffer in = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
    if (in.getInt() != 0x01312f76) {
      throw new IllegalArgumentException("no OpenEXR file");
    }
    int version = in.getInt();
    Map<String, byte[]> attributes = new LinkedHashMap<>();
    Map<String, String> types = new LinkedHashMap<>();
    for (String name = text(in); !name.isEmpty(); name = text(in)) {
      types.put(name, text(in));
      byte[] value = new byte[in.getInt()];
      in.get(value);
      attributes.put(name, value);
    }
    ByteBuffer window = little(attributes.get("dataWindow"));
    int width = window.getInt(8) + 1;
    int height = window.getInt(12) + 1;
    Map<String, float[]> channels = channels(little(attributes.get("channels")), width * height);
    long[] offsets = new long[(height + 15) / 16];
    in.asLongBuffer().get(offsets);
    for (long offset : offsets) {
      in.position((int) offset);
      block(in, width, height, channels);
    }
    if (in.hasRemaining()) {
      throw new IllegalArgumentException("bytes after the last block");
    }
    return new ExrFixture(width, height, version, attributes, types, channels);
  }

  private static void block(ByteBuffer in, int width, int height, Map<String, float[]> channels)
      throws DataFormatException {
    int first = in.getInt();
    byte[] packed = new byte[in.getInt()];
    in.get(packed);
    int rows = Math.min(16, height - first);
    ByteBuffer lines = little(unpacked(packed, 4 * width * rows * channels.size()));
    for (int y = first; y < first + rows; y++) {
      for (float[] channel : channels.values()) {
        for (int x = 0; x < width; x++) {
          channel[y * width + x] = lines.getFloat();
        }
      }
    }
  }

  private static byte[] unpacked(byte[] packed, int size) throws DataFormatException {
    if (packed.length == size) {
      return packed;
    }
    byte[] bytes = new byte[size];
    Inflater inflater = new Inflater();
    inflater.setInput(packed);
    int length = inflater.inflate(bytes);
    if (length != size || !inflater.finished()) {
      throw new IllegalArgumentException("wrong size of a block");
    }
    inflater.end();
    for (int i = 1; i < size; i++) {
      bytes[i] = (byte) (bytes[i - 1] + bytes[i] - 128);
    }
    byte[] merged = new byte[size];
    for (int i = 0, low = 0, high = (size + 1) / 2; i < size; i++) {
      merged[i] = i % 2 == 0 ? bytes[low++] : bytes[high++];
    }
    return merged;
  }

  private static Map<String, float[]> channels(ByteBuffer list, int pixels) {
    Map<String, float[]> channels = new LinkedHashMap<>();
    for (String name = text(list); !name.isEmpty(); name = text(list)) {
      if (list.getInt() != 2 || list.getInt() != 0 || list.getInt() != 1 || list.getInt() != 1) {
        throw new IllegalArgumentException("expected whole float channels");
      }
      channels.put(name, new float[pixels]);
    }
    return channels;
  }

  String string(String attribute) {
    return new String(attributes.get(attribute), StandardCharsets.UTF_8);
  }

  private static ByteBuffer little(byte[] bytes) {
    return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  private static String text(ByteBuffer in) {
    StringBuilder text = new StringBuilder();
    for (byte b = in.get(); b != 0; b = in.get()) {
      text.append((char) b);
    }
    return text.toString();
  }
}
