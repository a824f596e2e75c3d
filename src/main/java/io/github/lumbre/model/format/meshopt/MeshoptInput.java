package io.github.lumbre.model.format.meshopt;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import java.nio.ByteBuffer;

/** The bytes of a stream, read from front to back, up to its tail. Mutable. */
final class MeshoptInput {
  private final ByteBuffer bytes;
  private final String location;
  private int at;
  private int end;

  MeshoptInput(ByteBuffer bytes, String location) {
    this.bytes = bytes;
    this.location = location;
    end = bytes.limit();
  }

  /** Checks the number of bytes that follow. */
  void requireAtLeast(long count) throws ModelFormatException {
    if (count > end - at) {
      throw malformed("expected at least " + count + " more bytes, found " + (end - at));
    }
  }

  /** Reads the first byte, which must have a value. */
  void requireHeader(int expected) throws ModelFormatException {
    int found = unsignedByte();
    if (found != expected) {
      throw malformed("expected 0x%02x at byte 0, found 0x%02x".formatted(expected, found));
    }
  }

  /** Sets the last bytes apart, and returns the index of the first of them. */
  int reserveTail(int size) throws ModelFormatException {
    requireAtLeast(size);
    end -= size;
    return end;
  }

  /** Skips bytes, and returns the index of the first of them. */
  int skip(int count) throws ModelFormatException {
    requireAtLeast(count);
    int from = at;
    at += count;
    return from;
  }

  int unsignedByte() throws ModelFormatException {
    return unsignedByte(skip(1));
  }

  int unsignedByte(int index) {
    return bytes.get(index) & 0xff;
  }

  /** Returns an unsigned integer of at most 32 bits, of seven bits per byte, the lowest first. */
  int varint() throws ModelFormatException {
    int value = 0;
    for (int shift = 0; shift < 35; shift += 7) {
      int next = unsignedByte();
      value |= (next & 0x7f) << shift;
      if (next < 0x80) {
        return value;
      }
    }
    throw malformed("expected a number of at most 5 bytes, found a longer one");
  }

  /** Returns the signed integer that an unsigned one stands for: 0, -1, 1, -2, and so on. */
  static int signed(int value) {
    return value >>> 1 ^ -(value & 1);
  }

  /** Checks that the tail follows. */
  void requireEnd() throws ModelFormatException {
    if (at != end) {
      throw malformed("expected its tail, found " + (end - at) + " more bytes before it");
    }
  }

  ModelFormatException malformed(String message) {
    return exception(Kind.MALFORMED, message);
  }

  ModelFormatException unsupported(String message) {
    return exception(Kind.UNSUPPORTED, message);
  }

  private ModelFormatException exception(Kind kind, String message) {
    return kind.at(location, "byte " + at + " of its meshopt data: " + message);
  }
}
