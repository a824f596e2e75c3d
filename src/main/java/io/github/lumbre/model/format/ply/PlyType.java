package io.github.lumbre.model.format.ply;

import java.util.Optional;

/** The number types of PLY. */
enum PlyType {
  INT8(1, Byte.MIN_VALUE, Byte.MAX_VALUE),
  UINT8(1, 0, 0xff),
  INT16(2, Short.MIN_VALUE, Short.MAX_VALUE),
  UINT16(2, 0, 0xffff),
  INT32(4, Integer.MIN_VALUE, Integer.MAX_VALUE),
  UINT32(4, 0, 0xffffffffL),
  FLOAT32(4, 0, 0),
  FLOAT64(8, 0, 0);

  private final int bytes;
  private final long min;
  private final long max;

  PlyType(int bytes, long min, long max) {
    this.bytes = bytes;
    this.min = min;
    this.max = max;
  }

  /** Returns the type of a name in a header; empty if there is none. */
  static Optional<PlyType> of(String name) {
    return switch (name) {
      case "char", "int8" -> Optional.of(INT8);
      case "uchar", "uint8" -> Optional.of(UINT8);
      case "short", "int16" -> Optional.of(INT16);
      case "ushort", "uint16" -> Optional.of(UINT16);
      case "int", "int32" -> Optional.of(INT32);
      case "uint", "uint32" -> Optional.of(UINT32);
      case "float", "float32" -> Optional.of(FLOAT32);
      case "double", "float64" -> Optional.of(FLOAT64);
      default -> Optional.empty();
    };
  }

  /** Returns the size of a binary number. */
  int bytes() {
    return bytes;
  }

  boolean isInteger() {
    return this != FLOAT32 && this != FLOAT64;
  }

  /** Returns the smallest value of an integer type. */
  long min() {
    return min;
  }

  /** Returns the largest value of an integer type. */
  long max() {
    return max;
  }
}
