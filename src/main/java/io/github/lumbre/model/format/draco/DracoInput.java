package io.github.lumbre.model.format.draco;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;

/** The bytes of a stream, read from front to back; numbers are little-endian. Mutable. */
final class DracoInput {
  private final byte[] bytes;
  private final String location;
  private final DracoLimits.Memory memory;
  private int at;

  DracoInput(byte[] bytes, String location, DracoLimits.Memory memory) {
    this.bytes = bytes;
    this.location = location;
    this.memory = memory;
  }

  /** Returns all bytes of the stream. */
  byte[] bytes() {
    return bytes;
  }

  /** Returns the index of the next byte. */
  int position() {
    return at;
  }

  /** Returns the number of bytes that follow. */
  int remaining() {
    return bytes.length - at;
  }

  /**
   * Skips bytes.
   *
   * @return the index of the first of them
   */
  int skip(long count) throws ModelFormatException {
    if (count < 0 || count > remaining()) {
      throw malformed("expected " + count + " bytes, found the last " + remaining());
    }
    int from = at;
    at += (int) count;
    return from;
  }

  int unsignedByte() throws ModelFormatException {
    return bytes[skip(1)] & 0xff;
  }

  int signedByte() throws ModelFormatException {
    return bytes[skip(1)];
  }

  int unsignedShort() throws ModelFormatException {
    return (int) integer(2);
  }

  int integer() throws ModelFormatException {
    return (int) integer(4);
  }

  float number() throws ModelFormatException {
    return Float.intBitsToFloat(integer());
  }

  /** Returns an unsigned integer of at most 4 bytes. */
  long integer(int size) throws ModelFormatException {
    int from = skip(size);
    long value = 0;
    for (int i = size - 1; i >= 0; i--) {
      value = value << 8 | bytes[from + i] & 0xff;
    }
    return value;
  }

  /** Returns an unsigned integer of at most 32 bits, of seven bits per byte, the lowest first. */
  long varint() throws ModelFormatException {
    long value = 0;
    for (int shift = 0; shift < 35; shift += 7) {
      int next = unsignedByte();
      value |= (long) (next & 0x7f) << shift;
      if (next < 0x80) {
        return value;
      }
    }
    throw malformed("expected a number of at most 5 bytes, found a longer one");
  }

  /** Returns a variable-length number of things, which must be in [0, max]. */
  int count(String things, long max) throws ModelFormatException {
    long count = varint();
    if (count > max) {
      throw malformed("expected at most " + max + " " + things + ", found " + count);
    }
    return (int) count;
  }

  /** Counts memory that is about to be allocated. */
  void allocate(long size) throws ModelFormatException {
    memory.allocate(size);
  }

  /** Returns new integers, whose memory is counted. */
  int[] integers(long count) throws ModelFormatException {
    allocate(Integer.BYTES * count);
    if (count > Integer.MAX_VALUE - 8) {
      throw malformed("expected at most 2147483639 numbers, found " + count);
    }
    return new int[(int) count];
  }

  ModelFormatException malformed(String message) {
    return exception(Kind.MALFORMED, message);
  }

  ModelFormatException unsupported(String message) {
    return exception(Kind.UNSUPPORTED, message);
  }

  private ModelFormatException exception(Kind kind, String message) {
    return kind.at(location, "byte " + at + " of its Draco data: " + message);
  }
}
