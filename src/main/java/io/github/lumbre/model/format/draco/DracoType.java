package io.github.lumbre.model.format.draco;

import java.nio.ByteBuffer;

/** The types of numbers in an attribute, in the order of their codes, which begin at 1. */
public enum DracoType {
  INT8(1),
  UINT8(1),
  INT16(2),
  UINT16(2),
  INT32(4),
  UINT32(4),
  INT64(8),
  UINT64(8),
  FLOAT32(4),
  FLOAT64(8),
  BOOL(1);

  private final int size;

  DracoType(int size) {
    this.size = size;
  }

  /** Returns the number of bytes. */
  public int size() {
    return size;
  }

  /** Returns whether values are integers of at most 32 bits. */
  boolean isInteger() {
    return ordinal() <= UINT32.ordinal();
  }

  /** Appends the low bits of an integer. */
  void put(ByteBuffer target, int value) {
    switch (size) {
      case 1 -> target.put((byte) value);
      case 2 -> target.putShort((short) value);
      default -> target.putInt(value);
    }
  }
}
