package io.github.lumbre.model.format.draco;

/** Reads numbers of a few bits, the lowest bit of a byte first; 0 after the last byte. Mutable. */
final class BitReader {
  private final byte[] bytes;
  private final int end;
  private int at;
  private long buffer;
  private int buffered;

  /**
   * @param from index of the first byte
   * @param end index after the last byte
   */
  BitReader(byte[] bytes, int from, int end) {
    this.bytes = bytes;
    this.end = end;
    at = from;
  }

  /** Returns a number of 0 to 32 bits. */
  int read(int bits) {
    while (buffered < bits) {
      long next = at < end ? bytes[at] & 0xff : 0;
      at++;
      buffer |= next << buffered;
      buffered += Byte.SIZE;
    }
    int value = (int) (buffer & (1L << bits) - 1);
    buffer >>>= bits;
    buffered -= bits;
    return value;
  }

  /** Returns the index after the last byte that was used, at least in part. */
  int position() {
    return at - buffered / Byte.SIZE;
  }
}
