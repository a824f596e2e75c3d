package io.github.lumbre.image.format.gif;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Decodes animated GIF files by the specification, independently of the writer and of Java, and
 * checks their structure.
 */
final class GifFixture {
  final int width;
  final int height;
  final int[] palette;
  final List<Frame> frames = new ArrayList<>();

  private final ByteBuffer in;

  /**
   * A frame.
   *
   * @param screen the whole screen, 0 where it is transparent
   * @param hundredths time in 1/100 s
   * @param pixels of the rectangle that the file holds
   */
  record Frame(int[] screen, int hundredths, int pixels) {}

  GifFixture(byte[] file) {
    in = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
    assertThat(text(6)).isEqualTo("GIF89a");
    width = next16();
    height = next16();
    int flags = next();
    assertThat(flags & 0x80).isNotZero();
    in.position(in.position() + 2);
    palette = new int[2 << (flags & 7)];
    for (int i = 0; i < palette.length; i++) {
      palette[i] = 0xff << 24 | next() << 16 | next() << 8 | next();
    }
    assertThat(next()).isEqualTo(0x21);
    assertThat(next()).isEqualTo(0xff);
    assertThat(next()).isEqualTo(11);
    assertThat(text(11)).isEqualTo("NETSCAPE2.0");
    assertThat(new int[] {next(), next(), next16(), next()}).containsExactly(3, 1, 0, 0);
    int[] screen = new int[width * height];
    int mark = next();
    while (mark != 0x3b) {
      screen = readFrame(mark, screen);
      mark = next();
    }
    assertThat(in.hasRemaining()).isFalse();
  }

  /** Reads a frame and returns the screen before the next one. */
  private int[] readFrame(int mark, int[] before) {
    assertThat(new int[] {mark, next(), next()}).containsExactly(0x21, 0xf9, 4);
    int flags = next();
    int hundredths = next16();
    int transparent = next();
    assertThat(next()).isZero();
    assertThat(next()).isEqualTo(0x2c);
    int left = next16();
    int top = next16();
    int columns = next16();
    int rows = next16();
    assertThat(left + columns).isLessThanOrEqualTo(width);
    assertThat(top + rows).isLessThanOrEqualTo(height);
    assertThat(next()).isZero();
    int[] screen = before.clone();
    byte[] indices = decode(in, columns * rows);
    for (int i = 0; i < indices.length; i++) {
      int index = indices[i] & 0xff;
      if ((flags & 1) == 0 || index != transparent) {
        screen[(top + i / columns) * width + left + i % columns] = palette[index];
      }
    }
    frames.add(new Frame(screen, hundredths, columns * rows));
    assertThat(flags >> 2).isIn(1, 2);
    return flags >> 2 == 1 ? screen : new int[width * height];
  }

  /** Decodes a number of pixels and checks that nothing is left over. */
  static byte[] decode(ByteBuffer in, int pixels) {
    int pixelBits = in.get();
    assertThat(pixelBits).isBetween(2, 8);
    byte[] data = blocks(in);
    byte[] pixelsOut = new byte[pixels];
    byte[][] table = new byte[4096][];
    int clear = 1 << pixelBits;
    int size = clear + 2;
    int bits = pixelBits + 1;
    byte[] last = null;
    int at = 0;
    int bit = 0;
    while (true) {
      int code = 0;
      for (int i = 0; i < bits; i++, bit++) {
        code |= (data[bit / 8] >> bit % 8 & 1) << i;
      }
      if (code == clear) {
        size = clear + 2;
        bits = pixelBits + 1;
        last = null;
        continue;
      }
      if (code == clear + 1) {
        break;
      }
      assertThat(code).isLessThanOrEqualTo(last == null ? clear : size);
      byte[] string = code < clear ? new byte[] {(byte) code} : code < size ? table[code] : null;
      if (last != null) {
        byte[] longer = Arrays.copyOf(last, last.length + 1);
        longer[last.length] = string == null ? last[0] : string[0];
        string = string == null ? longer : string;
        if (size < 4096) {
          table[size++] = longer;
        }
        bits = size == 1 << bits && bits < 12 ? bits + 1 : bits;
      }
      System.arraycopy(string, 0, pixelsOut, at, string.length);
      at += string.length;
      last = string;
    }
    assertThat(at).isEqualTo(pixels);
    assertThat((bit + 7) / 8).isEqualTo(data.length);
    return pixelsOut;
  }

  private static byte[] blocks(ByteBuffer in) {
    ByteArrayOutputStream data = new ByteArrayOutputStream();
    for (int length = in.get() & 0xff; length > 0; length = in.get() & 0xff) {
      byte[] block = new byte[length];
      in.get(block);
      data.writeBytes(block);
    }
    return data.toByteArray();
  }

  private String text(int length) {
    byte[] text = new byte[length];
    in.get(text);
    return new String(text, StandardCharsets.US_ASCII);
  }

  private int next() {
    return in.get() & 0xff;
  }

  private int next16() {
    return in.getShort() & 0xffff;
  }
}
