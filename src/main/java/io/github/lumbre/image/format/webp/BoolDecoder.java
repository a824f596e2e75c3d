package io.github.lumbre.image.format.webp;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;

/** Reads bits that were coded with probabilities (RFC 6386, sec. 7). Mutable. */
final class BoolDecoder {
  private static final int EVEN = 128;

  private final byte[] bytes;
  private final int end;
  private int position;
  private int value;

  /** The number of bits of {@link #value} below the ones that are compared; negative if none. */
  private int below = -Byte.SIZE;

  /** The range of the comparison minus 1: 127 to 254 between two bits. */
  private int range = 254;

  /** Reads from a position to another, which is not read. */
  BoolDecoder(byte[] bytes, int from, int end) {
    this.bytes = bytes;
    this.position = from;
    this.end = end;
  }

  /**
   * Returns the next bit.
   *
   * @param probability of 0, in units of 1/256, from 0 to 255
   */
  int bit(int probability) throws ImageFormatException {
    if (below < 0) {
      load();
    }
    int split = range * probability >> 8;
    int bit = value >> below > split ? 1 : 0;
    if (bit == 1) {
      value -= split + 1 << below;
      range -= split + 1;
    } else {
      range = split;
    }
    if (range < 127) {
      int shift = Integer.numberOfLeadingZeros(range + 1) - 24;
      range = (range + 1 << shift) - 1;
      below -= shift;
    }
    return bit;
  }

  private void load() throws ImageFormatException {
    if (position == end) {
      throw malformed("VP8 is truncated");
    }
    value = value << 8 | bytes[position++] & 0xff;
    below += 8;
  }

  /** Returns the next bit, which is 0 or 1 with the same probability, as a truth value. */
  boolean flag() throws ImageFormatException {
    return bit(EVEN) == 1;
  }

  /** Returns an unsigned number of some bits. */
  int unsigned(int bits) throws ImageFormatException {
    int number = 0;
    for (int i = 0; i < bits; i++) {
      number = 2 * number + bit(EVEN);
    }
    return number;
  }

  /** Returns a number of some bits that are followed by its sign. */
  int signed(int bits) throws ImageFormatException {
    return withSign(unsigned(bits));
  }

  /** Returns a number with the sign that is read. */
  int withSign(int magnitude) throws ImageFormatException {
    return flag() ? -magnitude : magnitude;
  }

  /** Returns a signed number if a flag before it is set, otherwise 0. */
  int optional(int bits) throws ImageFormatException {
    return flag() ? signed(bits) : 0;
  }

  /** Returns numbers that are {@link #optional} each. */
  int[] optionals(int count, int bits) throws ImageFormatException {
    int[] numbers = new int[count];
    for (int i = 0; i < count; i++) {
      numbers[i] = optional(bits);
    }
    return numbers;
  }
}
