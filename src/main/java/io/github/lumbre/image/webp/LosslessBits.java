package io.github.lumbre.image.webp;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;

/** Reads bits, the lowest of each byte first. Mutable. */
final class LosslessBits {
  /** The number of bits that can be read at once. */
  static final int MAX_BITS = 18;

  private final byte[] bytes;
  private final int end;
  private int position;
  private long window;

  /** The number of bits in the window, with zeros that follow the end of the data. */
  private int held;

  /** Reads from a position to another, which is not read. */
  LosslessBits(byte[] bytes, int from, int end) {
    this.bytes = bytes;
    this.position = from;
    this.end = end;
  }

  /**
   * Returns the next {@link #MAX_BITS} bits without consuming them; zeros follow the end of the
   * data.
   */
  int peek() {
    while (held < MAX_BITS) {
      window |= (position < end ? bytes[position] & 0xffL : 0) << held;
      position++;
      held += Byte.SIZE;
    }
    return (int) window & (1 << MAX_BITS) - 1;
  }

  /** Consumes at most {@link #MAX_BITS} bits. */
  void skip(int bits) throws ImageFormatException {
    window >>>= bits;
    held -= bits;
    if (held < Byte.SIZE * (position - end)) {
      throw malformed("WebP is truncated");
    }
  }

  /** Returns a number of at most {@link #MAX_BITS} bits. */
  int read(int bits) throws ImageFormatException {
    int number = peek() & (1 << bits) - 1;
    skip(bits);
    return number;
  }

  boolean flag() throws ImageFormatException {
    return read(1) == 1;
  }
}
