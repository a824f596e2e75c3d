package io.github.lumbre.image.ktx;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;

/** Reads numbers of a few bits, the lowest bit of a byte first. Mutable. */
final class BasisBits {
  private final KtxInput in;
  private int at;
  private long buffer;
  private int buffered;

  BasisBits(KtxInput in) {
    this.in = in;
  }

  /** Returns the next bits, at most 32, and zeros after the last one, without consuming them. */
  int peek(int count) {
    while (buffered < count) {
      long next = at < in.size() ? in.file()[in.from() + at] & 0xff : 0;
      at++;
      buffer |= next << buffered;
      buffered += Byte.SIZE;
    }
    return (int) (buffer & (1L << count) - 1);
  }

  /** Consumes bits that were peeked at. */
  void skip(int count) throws ImageFormatException {
    buffer >>>= count;
    buffered -= count;
    if (at - buffered / Byte.SIZE > in.size()) {
      throw damaged("ends after " + in.size() + " bytes");
    }
  }

  int read(int count) throws ImageFormatException {
    int value = peek(count);
    skip(count);
    return value;
  }

  /**
   * Returns a number of 32 bits in chunks, the lowest first; a bit after each chunk states whether
   * more follow.
   */
  long readChunks(int bits) throws ImageFormatException {
    long value = 0;
    for (int shift = 0; shift < Integer.SIZE; shift += bits) {
      int chunk = read(bits + 1);
      value |= (chunk & (1L << bits) - 1) << shift;
      if (chunk >> bits == 0) {
        return value;
      }
    }
    throw damaged("has a number of more than 32 bits");
  }

  ImageFormatException damaged(String problem) {
    return malformed("KTX is damaged: " + in.name() + " " + problem);
  }
}
