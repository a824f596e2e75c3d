package io.github.lumbre.image.format.zstd;

import io.github.lumbre.image.ImageFormatException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Bits that are read from the end of their bytes to the front (RFC 8878, section 4). The highest
 * bit that is set in the last byte marks the end. Mutable.
 */
final class BackwardBits {
  private final ZstdInput in;
  private final ByteBuffer bytes;
  private final int from;

  /** The number of bits that are left; negative after reading more than there are. */
  private long left;

  /**
   * @param in the bytes of the bits, and no others
   */
  BackwardBits(ZstdInput in) throws ImageFormatException {
    this.in = in;
    bytes = ByteBuffer.wrap(in.bytes()).order(ByteOrder.LITTLE_ENDIAN);
    from = in.position();
    int last = in.remaining() == 0 ? 0 : bytes.get(in.end() - 1) & 0xff;
    if (last == 0) {
      throw in.malformed("expected the bits of a stream, found none");
    }
    int unused = Integer.numberOfLeadingZeros(last) - (Integer.SIZE - Byte.SIZE) + 1;
    left = (long) Byte.SIZE * in.remaining() - unused;
  }

  /** Returns the next bits, and zeros after the last one, without consuming them. */
  int peek(int count) {
    long start = left - count;
    long mask = (1L << count) - 1;
    if (start < 0) {
      return left <= 0 ? 0 : (int) (word(0) << -start & mask);
    }
    return (int) (word((int) (start >> 3)) >>> (start & 7) & mask);
  }

  /** Returns at least 57 bits from a byte of the stream on, the lowest first. */
  private long word(int offset) {
    int at = from + offset;
    if (at + Long.BYTES <= bytes.limit()) {
      return bytes.getLong(at);
    }
    long word = 0;
    for (int i = bytes.limit() - 1; i >= at; i--) {
      word = word << Byte.SIZE | bytes.get(i) & 0xff;
    }
    return word;
  }

  void skip(int count) {
    left -= count;
  }

  /** Returns a number of at most 32 bits; bits after the last one are 0. */
  int read(int count) {
    int value = peek(count);
    left -= count;
    return value;
  }

  /** Returns whether more bits were read than there are. */
  boolean isExceeded() {
    return left < 0;
  }

  /** Checks that all bits were read, and no more. */
  void requireEnd() throws ImageFormatException {
    if (left != 0) {
      String found = Math.abs(left) + (left > 0 ? " bits too many" : " bits too few");
      throw in.malformed("expected the end of a stream, found " + found);
    }
  }
}
