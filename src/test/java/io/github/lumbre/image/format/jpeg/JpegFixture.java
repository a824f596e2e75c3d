package io.github.lumbre.image.format.jpeg;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Builds baseline JPEG files of constant 8x8 blocks (ITU-T T.81), whose only error is the rounding
 * of the transform. Mutable.
 */
public final class JpegFixture {
  /** The value of a component in a block. */
  public interface Values {
    int at(int component, int blockX, int blockY);
  }

  private final ByteArrayOutputStream file = new ByteArrayOutputStream();
  private int bits;
  private int bitCount;

  public JpegFixture() {
    file.writeBytes(new byte[] {(byte) 0xff, (byte) 0xd8});
  }

  JpegFixture segment(int marker, byte[] content) {
    file.write(0xff);
    file.write(marker);
    file.write(content.length + 2 >> 8);
    file.write(content.length + 2);
    file.writeBytes(content);
    return this;
  }

  JpegFixture bytes(int... bytes) {
    for (int b : bytes) {
      file.write(b);
    }
    return this;
  }

  JpegFixture jfif() {
    return segment(0xe0, new byte[] {'J', 'F', 'I', 'F', 0, 1, 1, 0, 0, 1, 0, 1, 0, 0});
  }

  /**
   * @param transform 0 for none, 1 for YCbCr, 2 for YCCK
   */
  JpegFixture adobe(int transform) {
    byte[] content = "Adobe\0d\0\0\0\0\0".getBytes(StandardCharsets.US_ASCII);
    content[11] = (byte) transform;
    return segment(0xee, content);
  }

  /**
   * Adds quantization by 1, a frame with one component per character of {@code ids}, and tables.
   */
  public JpegFixture header(int blocksX, int blocksY, String ids) {
    byte[] ones = new byte[65];
    Arrays.fill(ones, 1, 65, (byte) 1);
    segment(0xdb, ones);
    ByteArrayOutputStream frame = new ByteArrayOutputStream();
    frame.writeBytes(new byte[] {8, 0, (byte) (8 * blocksY), 0, (byte) (8 * blocksX)});
    frame.write(ids.length());
    for (byte id : ids.getBytes(StandardCharsets.ISO_8859_1)) {
      frame.writeBytes(new byte[] {id, 0x11, 0});
    }
    segment(0xc0, frame.toByteArray());
    // Four-bit codes for the sizes of differences, 0 to 11; a one-bit code for the end of a block.
    byte[] sizes = new byte[1 + 16 + 12];
    sizes[4] = 12;
    for (int i = 0; i < 12; i++) {
      sizes[17 + i] = (byte) i;
    }
    segment(0xc4, sizes);
    byte[] end = new byte[1 + 16 + 1];
    end[0] = 0x10;
    end[1] = 1;
    return segment(0xc4, end);
  }

  public JpegFixture scan(int blocksX, int blocksY, String ids, Values values) {
    ByteArrayOutputStream start = new ByteArrayOutputStream();
    start.write(ids.length());
    for (byte id : ids.getBytes(StandardCharsets.ISO_8859_1)) {
      start.writeBytes(new byte[] {id, 0});
    }
    start.writeBytes(new byte[] {0, 63, 0});
    segment(0xda, start.toByteArray());
    int[] last = new int[ids.length()];
    for (int y = 0; y < blocksY; y++) {
      for (int x = 0; x < blocksX; x++) {
        for (int c = 0; c < ids.length(); c++) {
          int mean = 8 * (values.at(c, x, y) - 128);
          difference(mean - last[c]);
          last[c] = mean;
          put(0, 1);
        }
      }
    }
    while (bitCount != 0) {
      put(1, 1);
    }
    return this;
  }

  private void difference(int value) {
    int size = 32 - Integer.numberOfLeadingZeros(Math.abs(value));
    put(size, 4);
    put(value < 0 ? value + (1 << size) - 1 : value, size);
  }

  private void put(int value, int count) {
    for (int i = count - 1; i >= 0; i--) {
      bits = bits << 1 | value >> i & 1;
      bitCount++;
      if (bitCount == 8) {
        file.write(bits);
        if ((bits & 0xff) == 0xff) {
          file.write(0);
        }
        bits = 0;
        bitCount = 0;
      }
    }
  }

  byte[] unfinished() {
    return file.toByteArray();
  }

  public byte[] end() {
    return bytes(0xff, 0xd9).unfinished();
  }
}
