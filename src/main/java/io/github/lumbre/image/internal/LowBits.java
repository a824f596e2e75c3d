package io.github.lumbre.image.internal;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;

/** Reads numbers of a few bits, the lowest bit of a byte first. Mutable. */
public class LowBits {
  private final byte[] bytes;
  private final int end;
  private final String truncated;
  private int at;
  private long buffer;

  /** The number of bits in the buffer, with zeros that follow the last byte. */
  private int buffered;

  /**
   * Reads from a position to another, which is not read.
   *
   * @param truncated the message if there are too few bits
   */
  public LowBits(byte[] bytes, int from, int end, String truncated) {
    this.bytes = bytes;
    this.at = from;
    this.end = end;
    this.truncated = truncated;
  }

  /** Returns the next bits, at most 32, and zeros after the last one, without consuming them. */
  public final int peek(int count) {
    while (buffered < count) {
      buffer |= (at < end ? bytes[at] & 0xffL : 0) << buffered;
      at++;
      buffered += Byte.SIZE;
    }
    return (int) (buffer & (1L << count) - 1);
  }

  /** Consumes bits that were peeked at. */
  public final void skip(int count) throws ImageFormatException {
    buffer >>>= count;
    buffered -= count;
    if (buffered < Byte.SIZE * (at - end)) {
      throw malformed(truncated);
    }
  }

  /** Returns a number of at most 32 bits. */
  public final int read(int count) throws ImageFormatException {
    int value = peek(count);
    skip(count);
    return value;
  }

  /** Returns whether the next bit is 1. */
  public final boolean flag() throws ImageFormatException {
    return read(1) == 1;
  }
}
