package io.github.lumbre.model.format.draco;

import io.github.lumbre.model.ModelFormatException;

/**
 * The state of a range asymmetric numeral system, and the bytes that refill it, the last one first.
 * Mutable.
 *
 * <p>Source: J. Duda, Asymmetric numeral systems, 2013; Draco specification, Rans Decoding.
 */
final class RansState {
  private final byte[] bytes;
  private final int start;
  private final int base;
  private int at;

  /** The number, at least the base until the bytes are used up; never negative. */
  int value;

  private RansState(byte[] bytes, int start, int at, int base) {
    this.bytes = bytes;
    this.start = start;
    this.at = at;
    this.base = base;
  }

  /**
   * Reads the number of bytes, and the bytes. The highest two bits of the last byte are the number
   * of bytes, less one, of the first state.
   *
   * @param base a power of two, at most 2^22; the state is refilled if it is lower
   */
  static RansState read(DracoInput input, int base) throws ModelFormatException {
    int size = input.count("bytes of coded numbers", input.remaining());
    int start = input.skip(size);
    if (size == 0) {
      throw input.malformed("expected at least one byte of coded numbers, found none");
    }
    byte[] bytes = input.bytes();
    int length = (bytes[start + size - 1] >> 6 & 3) + 1;
    if (length > size) {
      throw input.malformed("expected a state of " + length + " bytes, found " + size);
    }
    RansState state = new RansState(bytes, start, start + size - length, base);
    int first = bytes[start + size - 1] & 0x3f;
    for (int i = 2; i <= length; i++) {
      first = first << Byte.SIZE | bytes[start + size - i] & 0xff;
    }
    state.value = base + first;
    if (state.value >= base << Byte.SIZE) {
      throw input.malformed(
          "expected a state below " + (base << Byte.SIZE) + ", found " + state.value);
    }
    return state;
  }

  void refill() {
    while (value < base && at > start) {
      value = value << Byte.SIZE | bytes[--at] & 0xff;
    }
  }
}
