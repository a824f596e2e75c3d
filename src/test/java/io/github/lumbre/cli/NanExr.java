package io.github.lumbre.cli;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** An uncompressed OpenEXR file of another program, in which a pixel is NaN. */
final class NanExr {
  private NanExr() {}

  /** Returns the file of a picture of one value, but with a pixel of NaN. */
  static byte[] bytes(int width, int height, float value) {
    ByteBuffer out = ByteBuffer.allocate(1 << 16).order(ByteOrder.LITTLE_ENDIAN);
    out.putInt(20000630).putInt(2);
    ByteBuffer channels = ByteBuffer.allocate(3 * 18 + 1).order(ByteOrder.LITTLE_ENDIAN);
    for (char name : new char[] {'B', 'G', 'R'}) {
      channels.put((byte) name).put((byte) 0).putInt(2).putInt(0).putInt(1).putInt(1);
    }
    attribute(out, "channels", "chlist", channels.array());
    attribute(out, "compression", "compression", new byte[1]);
    byte[] window = little(16).putInt(0).putInt(0).putInt(width - 1).putInt(height - 1).array();
    attribute(out, "dataWindow", "box2i", window);
    attribute(out, "displayWindow", "box2i", window);
    attribute(out, "lineOrder", "lineOrder", new byte[1]);
    attribute(out, "pixelAspectRatio", "float", little(4).putFloat(1).array());
    attribute(out, "screenWindowCenter", "v2f", new byte[8]);
    attribute(out, "screenWindowWidth", "float", little(4).putFloat(1).array());
    out.put((byte) 0);
    int row = 8 + 12 * width;
    int first = out.position() + 8 * height;
    for (int y = 0; y < height; y++) {
      out.putLong(first + (long) y * row);
    }
    for (int y = 0; y < height; y++) {
      out.putInt(y).putInt(12 * width);
      for (int i = 0; i < 3 * width; i++) {
        out.putFloat(y == 2 && i % width == 2 ? Float.NaN : value);
      }
    }
    return Arrays.copyOf(out.array(), out.position());
  }

  private static ByteBuffer little(int bytes) {
    return ByteBuffer.allocate(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  private static void attribute(ByteBuffer out, String name, String type, byte[] value) {
    out.put(name.getBytes(StandardCharsets.US_ASCII)).put((byte) 0);
    out.put(type.getBytes(StandardCharsets.US_ASCII)).put((byte) 0);
    out.putInt(value.length).put(value);
  }
}
