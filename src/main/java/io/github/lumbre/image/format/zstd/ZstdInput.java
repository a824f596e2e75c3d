package io.github.lumbre.image.format.zstd;

import io.github.lumbre.image.ImageFormatException;

/** Compressed bytes, read from front to back; numbers are little-endian. Mutable. */
final class ZstdInput {
  private final byte[] bytes;
  private final int end;
  private int at;

  /**
   * @param from index of the first byte
   * @param end index after the last byte
   */
  ZstdInput(byte[] bytes, int from, int end) {
    this.bytes = bytes;
    this.end = end;
    at = from;
  }

  /** Returns the array that contains the bytes. */
  byte[] bytes() {
    return bytes;
  }

  int position() {
    return at;
  }

  int end() {
    return end;
  }

  int remaining() {
    return end - at;
  }

  /**
   * Skips bytes.
   *
   * @return the index of the first of them
   */
  int skip(long count) throws ImageFormatException {
    if (count > remaining()) {
      throw malformed("expected " + count + " bytes, found the last " + remaining());
    }
    int from = at;
    at += (int) count;
    return from;
  }

  int unsignedByte() throws ImageFormatException {
    return bytes[skip(1)] & 0xff;
  }

  /** Returns an unsigned number of at most 5 bytes; of more bytes only the lowest 63 bits. */
  long number(int size) throws ImageFormatException {
    int from = skip(size);
    long value = 0;
    for (int i = size - 1; i >= 0; i--) {
      value = value << Byte.SIZE | bytes[from + i] & 0xff;
    }
    return value & Long.MAX_VALUE;
  }

  /** Skips bytes, and returns them as an input of their own. */
  ZstdInput part(long size) throws ImageFormatException {
    int from = skip(size);
    return new ZstdInput(bytes, from, at);
  }

  ImageFormatException malformed(String message) {
    return ImageFormatException.malformed(
        "Zstandard data are damaged at byte " + at + ": " + message);
  }
}
