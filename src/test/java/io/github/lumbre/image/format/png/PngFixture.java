package io.github.lumbre.image.format.png;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.function.IntBinaryOperator;
import java.util.zip.CRC32;
import java.util.zip.DeflaterOutputStream;

/** Builds valid and invalid PNG files chunk by chunk. */
public final class PngFixture {
  public static final int GRAY = 0;
  public static final int RGB = 2;
  public static final int PALETTE = 3;
  static final int GRAY_ALPHA = 4;
  public static final int RGBA = 6;

  private static final int[][] WHOLE = {{0, 0, 1, 1}};

  /** The first column, first row, column step and row step of the seven Adam7 passes. */
  static final int[][] ADAM7 = {
    {0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}
  };

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();

  public PngFixture() {
    out.writeBytes(new byte[] {(byte) 0x89, 'P', 'N', 'G', 13, 10, 26, 10});
  }

  public static int channels(int colorType) {
    return switch (colorType) {
      case RGB -> 3;
      case GRAY_ALPHA -> 2;
      case RGBA -> 4;
      default -> 1;
    };
  }

  public PngFixture chunk(String type, byte[] data) {
    byte[] body = new byte[4 + data.length];
    System.arraycopy(type.getBytes(StandardCharsets.US_ASCII), 0, body, 0, 4);
    System.arraycopy(data, 0, body, 4, data.length);
    CRC32 crc = new CRC32();
    crc.update(body);
    out.writeBytes(ByteBuffer.allocate(4).putInt(data.length).array());
    out.writeBytes(body);
    out.writeBytes(ByteBuffer.allocate(4).putInt((int) crc.getValue()).array());
    return this;
  }

  public PngFixture header(int width, int height, int depth, int colorType, boolean interlaced) {
    ByteBuffer data = ByteBuffer.allocate(13).putInt(width).putInt(height);
    data.put((byte) depth).put((byte) colorType).put((byte) 0).put((byte) 0);
    return chunk("IHDR", data.put((byte) (interlaced ? 1 : 0)).array());
  }

  /**
   * Adds the pixels, unfiltered.
   *
   * @param sample the value in a row (second argument) at column × channels + channel
   */
  public PngFixture data(
      int width,
      int height,
      int depth,
      int colorType,
      boolean interlaced,
      IntBinaryOperator sample) {
    int channels = channels(colorType);
    ByteArrayOutputStream raw = new ByteArrayOutputStream();
    for (int[] pass : interlaced ? ADAM7 : WHOLE) {
      for (int y = pass[1]; y < height && pass[0] < width; y += pass[3]) {
        raw.write(0);
        Bits bits = new Bits(raw);
        for (int x = pass[0]; x < width; x += pass[2]) {
          for (int c = 0; c < channels; c++) {
            bits.put(sample.applyAsInt(channels * x + c, y), depth);
          }
        }
        bits.end();
      }
    }
    return chunk("IDAT", deflated(raw.toByteArray()));
  }

  public byte[] end() {
    return chunk("IEND", new byte[0]).out.toByteArray();
  }

  public byte[] unfinished() {
    return out.toByteArray();
  }

  public static byte[] deflated(byte[] raw) {
    ByteArrayOutputStream packed = new ByteArrayOutputStream();
    try (DeflaterOutputStream deflater = new DeflaterOutputStream(packed)) {
      deflater.write(raw);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return packed.toByteArray();
  }

  /** Packs samples of 1 to 16 bits, the high bits first. */
  private static final class Bits {
    private final ByteArrayOutputStream out;
    private int held;
    private int count;

    Bits(ByteArrayOutputStream out) {
      this.out = out;
    }

    void put(int value, int depth) {
      for (int bit = depth - 1; bit >= 0; bit--) {
        held = held << 1 | value >> bit & 1;
        count++;
        if (count == 8) {
          out.write(held);
          count = 0;
          held = 0;
        }
      }
    }

    void end() {
      while (count != 0) {
        put(0, 1);
      }
    }
  }
}
