package io.github.lumbre.image.format.zstd;

import io.github.lumbre.image.ImageFormatException;
import java.util.Arrays;

/** Decoded bytes of a known number. Mutable. */
final class ZstdOutput {
  private final ZstdInput in;
  private final byte[] bytes;
  private int at;

  /**
   * @param in for messages
   */
  ZstdOutput(ZstdInput in, int size) {
    this.in = in;
    bytes = new byte[size];
  }

  /** Writes bytes of an array. */
  void copy(byte[] source, int from, int count) throws ImageFormatException {
    requireRoom(count);
    System.arraycopy(source, from, bytes, at, count);
    at += count;
  }

  /** Writes one byte several times. */
  void fill(byte value, int count) throws ImageFormatException {
    requireRoom(count);
    Arrays.fill(bytes, at, at + count, value);
    at += count;
  }

  /**
   * Writes bytes that were written before; they may overlap those that are written.
   *
   * @param offset from the first byte back to its source
   */
  void repeat(long offset, int count) throws ImageFormatException {
    requireRoom(count);
    if (offset < 1 || offset > at) {
      throw in.malformed("expected an offset from 1 to " + at + ", found " + offset);
    }
    int from = at - (int) offset;
    if (offset >= count) {
      System.arraycopy(bytes, from, bytes, at, count);
    } else {
      for (int i = 0; i < count; i++) {
        bytes[at + i] = bytes[from + i];
      }
    }
    at += count;
  }

  private void requireRoom(int count) throws ImageFormatException {
    if (count > bytes.length - at) {
      throw in.malformed("expected " + bytes.length + " decoded bytes, found more");
    }
  }

  /** Returns all bytes, after the last one was written. */
  byte[] complete() throws ImageFormatException {
    if (at < bytes.length) {
      throw in.malformed("expected " + bytes.length + " decoded bytes, found " + at);
    }
    return bytes;
  }
}
