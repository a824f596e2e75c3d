package io.github.lumbre.image.format.webp;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.BitSet;

/** Writes lossless WebP files bit by bit. Mutable. */
final class LosslessWriter {
  private final BitSet bits = new BitSet();
  private int count;

  /** Writes the header of a picture. */
  LosslessWriter(int width, int height) {
    number(0x2f, 8).number(width - 1, 14).number(height - 1, 14).number(0, 4);
  }

  /** Writes a number, its lowest bit first. */
  LosslessWriter number(int value, int length) {
    for (int i = 0; i < length; i++, count++) {
      bits.set(count, (value >> i & 1) == 1);
    }
    return this;
  }

  /** Writes a prefix code with a single symbol, which takes no bits. */
  LosslessWriter code(int symbol) {
    return number(0b101, 3).number(symbol, 8);
  }

  /** Writes five codes with a single symbol each: 0, but another one for green. */
  LosslessWriter codes(int green) {
    return code(green).code(0).code(0).code(0).code(0);
  }

  /** Writes a prefix code whose symbols 0 to 255 take 8 bits, the highest bit first. */
  LosslessWriter fullCode() {
    // The lengths have a code of one bit: 0 for 8, and 1 for 3 to 6 repetitions.
    number(0, 1).number(12 - 4, 4);
    for (int length : new int[] {17, 18, 0, 1, 2, 3, 4, 5, 16, 6, 7, 8}) {
      number(length == 8 || length == 16 ? 1 : 0, 3);
    }
    // Of 46 lengths, 42 repeat the last one 6 times, and one 3 times.
    number(1, 1).number(2, 3).number(44 - 2, 6).number(0, 1);
    for (int i = 0; i < 42; i++) {
      number(0b111, 3);
    }
    return number(0b001, 3);
  }

  /** Returns the file. */
  byte[] file() {
    byte[] data = Arrays.copyOf(bits.toByteArray(), (count + 7) / 8);
    ByteBuffer file = ByteBuffer.allocate(20 + data.length).order(ByteOrder.LITTLE_ENDIAN);
    return file.put(ascii("RIFF"))
        .putInt(12 + data.length)
        .put(ascii("WEBPVP8L"))
        .putInt(data.length)
        .put(data)
        .array();
  }

  private static byte[] ascii(String text) {
    return text.getBytes(StandardCharsets.US_ASCII);
  }
}
