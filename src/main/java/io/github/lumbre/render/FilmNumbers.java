package io.github.lumbre.render;

import java.nio.ByteBuffer;

/**
 * The encoding of numbers in films: 7 bits per byte, lowest bits first; the eighth bit is set if
 * more bytes follow.
 */
final class FilmNumbers {
  /** The maximum size of an encoded number, in bytes. */
  static final int MAX_BYTES = 9;

  private FilmNumbers() {}

  /** Writes a number ≥ 0. */
  static void put(ByteBuffer out, long number) {
    long rest = number;
    while (rest > 0x7f) {
      out.put((byte) (rest | 0x80));
      rest >>>= 7;
    }
    out.put((byte) rest);
  }

  /**
   * Reads a number from 0 to the largest one.
   *
   * @throws IllegalArgumentException if the number is larger
   * @throws java.nio.BufferUnderflowException if the bytes are truncated
   */
  static long get(ByteBuffer in, long largest) {
    long number = 0;
    for (int shift = 0; shift < Long.SIZE - 1; shift += 7) {
      byte bits = in.get();
      number |= (bits & 0x7fL) << shift;
      if (bits >= 0) {
        if (number > largest) {
          break;
        }
        return number;
      }
    }
    throw new IllegalArgumentException("expected a number up to " + largest + ", found " + number);
  }
}
