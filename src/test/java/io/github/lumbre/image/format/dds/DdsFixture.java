package io.github.lumbre.image.format.dds;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Writes DDS files. */
public final class DdsFixture {
  private static final int CODE = 4;

  private DdsFixture() {}

  private static ByteBuffer header(int width, int height, int bytes) {
    ByteBuffer out = ByteBuffer.allocate(bytes).order(ByteOrder.LITTLE_ENDIAN);
    out.put("DDS ".getBytes(StandardCharsets.US_ASCII)).putInt(124).putInt(0x1007);
    return out.putInt(height).putInt(width).putInt(76, 32);
  }

  /** Returns a file whose format has a name of four letters. */
  public static byte[] named(String name, int width, int height, byte[] data) {
    ByteBuffer out = header(width, height, 128 + data.length).putInt(80, CODE);
    return out.put(84, name.getBytes(StandardCharsets.US_ASCII)).put(128, data).array();
  }

  /** Returns a file whose format has a number. */
  static byte[] numbered(int format, int width, int height, byte[] data) {
    ByteBuffer out = header(width, height, 148 + data.length).putInt(80, CODE);
    out.put(84, "DX10".getBytes(StandardCharsets.US_ASCII));
    return out.putInt(128, format).putInt(132, 3).putInt(140, 1).put(148, data).array();
  }

  /** Returns a file whose pixels have masks. */
  static byte[] masked(int flags, int bits, int[] masks, int width, int height, byte[] data) {
    ByteBuffer out = header(width, height, 128 + data.length).putInt(80, flags).putInt(88, bits);
    for (int i = 0; i < masks.length; i++) {
      out.putInt(92 + 4 * i, masks[i]);
    }
    return out.put(128, data).array();
  }

  /** Returns random data. */
  public static byte[] data(int seed, int bytes) {
    byte[] data = new byte[bytes];
    new Random(seed).nextBytes(data);
    return data;
  }

  /** Returns random blocks of a mode of BC7. */
  static byte[] bc7(int mode, int blocks) {
    byte[] data = data(mode, 16 * blocks);
    for (int i = 0; i < data.length; i += 16) {
      data[i] = (byte) (data[i] & 0xff << mode + 1 | 1 << mode);
    }
    return data;
  }

  /** Returns files of all kinds, for mutation. */
  public static Stream<byte[]> files() {
    Stream<byte[]> named =
        Stream.of("DXT1", "DXT3", "DXT5", "ATI1", "ATI2")
            .map(name -> named(name, 7, 5, data(1, 64)));
    Stream<byte[]> bc7 = IntStream.range(0, 8).mapToObj(m -> numbered(98, 7, 5, bc7(m, 4)));
    int[] masks = {0xff0000, 0xff00, 0xff, 0xff000000};
    Stream<byte[]> others =
        Stream.of(
            masked(0x41, 32, masks, 7, 5, data(2, 140)),
            masked(0x40, 16, new int[] {0xf800, 0x7e0, 0x1f}, 7, 5, data(2, 70)),
            masked(0x20000, 8, new int[] {0xff}, 7, 5, data(2, 35)),
            numbered(87, 7, 5, data(2, 140)));
    return Stream.of(named, bc7, others).flatMap(files -> files);
  }

  static byte[] with(byte[] file, int at, int value) {
    return ByteBuffer.wrap(Arrays.copyOf(file, file.length))
        .order(ByteOrder.LITTLE_ENDIAN)
        .putInt(at, value)
        .array();
  }
}
