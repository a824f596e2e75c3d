package io.github.lumbre.cli.view;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;

/**
 * Packets of the protocol of the image viewer tev, which HDRView also reads. A packet is its length
 * in bytes, itself included, its type, and its content; numbers are little-endian, texts end with a
 * zero byte.
 */
final class TevPackets {
  private static final int CREATE_IMAGE = 4;
  private static final int UPDATE_IMAGE = 6;

  private TevPackets() {}

  /**
   * Returns the packet that creates a black image.
   *
   * @param channels names such as {@code R} or {@code normal.X}
   */
  static byte[] create(String name, int width, int height, List<String> channels) {
    ByteArrayOutputStream content = new ByteArrayOutputStream();
    content.write(1); // bring it to the front
    text(content, name);
    number(content, width);
    number(content, height);
    number(content, channels.size());
    channels.forEach(channel -> text(content, channel));
    return packet(CREATE_IMAGE, content.toByteArray());
  }

  /**
   * Returns the packet that replaces rows of an image.
   *
   * @param channels names of the channels to replace
   * @param first first row
   * @param rows number of rows
   * @param values one value for each channel, pixel by pixel, of the whole image
   */
  static byte[] update(
      String name, int width, List<String> channels, int first, int rows, float[] values) {
    int count = channels.size();
    ByteArrayOutputStream content = new ByteArrayOutputStream();
    content.write(0); // leave the focus where it is
    text(content, name);
    number(content, count);
    channels.forEach(channel -> text(content, channel));
    for (int number : new int[] {0, first, width, rows}) {
      number(content, number);
    }
    for (int i = 0; i < count; i++) {
      wide(content, i); // offset
    }
    for (int i = 0; i < count; i++) {
      wide(content, count); // stride
    }
    ByteBuffer data = buffer(Float.BYTES * rows * width * count);
    data.asFloatBuffer().put(values, first * width * count, rows * width * count);
    content.writeBytes(data.array());
    return packet(UPDATE_IMAGE, content.toByteArray());
  }

  private static byte[] packet(int type, byte[] content) {
    int length = Integer.BYTES + 1 + content.length;
    return buffer(length).putInt(length).put((byte) type).put(content).array();
  }

  private static void text(ByteArrayOutputStream out, String text) {
    out.writeBytes(text.replace('\0', ' ').getBytes(StandardCharsets.UTF_8));
    out.write(0);
  }

  private static void number(ByteArrayOutputStream out, int value) {
    out.writeBytes(buffer(Integer.BYTES).putInt(value).array());
  }

  private static void wide(ByteArrayOutputStream out, long value) {
    out.writeBytes(buffer(Long.BYTES).putLong(value).array());
  }

  private static ByteBuffer buffer(int bytes) {
    return ByteBuffer.allocate(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }
}
