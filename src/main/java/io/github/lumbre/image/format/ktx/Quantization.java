package io.github.lumbre.image.format.ktx;

import java.util.function.IntUnaryOperator;

/**
 * How values in [0, 255] are stored in fewer bits, or in bits and a digit of base 3 or 5 (Khronos
 * Data Format Specification 1.3, section 23.13).
 */
enum Quantization {
  BITS_4(4),
  BITS_5(5),
  BITS_8(8),
  TRIT_2(2, 3, 93, high -> high * 0b100010110),
  TRIT_4(4, 3, 22, high -> high << 6 | high),
  TRIT_6(6, 3, 5, high -> high << 4 | high >> 4),
  QUINT_3(3, 5, 26, high -> high << 7 | high << 1 | high >> 1),
  QUINT_5(5, 5, 6, high -> high << 5 | high >> 3);

  private final int bits;
  private final int base;
  private final int[] values;

  /** Without a digit: the bits are repeated. */
  Quantization(int bits) {
    this.bits = bits;
    base = 1;
    values = new int[1 << bits];
    for (int stored = 0; stored < values.length; stored++) {
      values[stored] =
          bits == Byte.SIZE ? stored : (stored << bits | stored) >> 2 * bits - Byte.SIZE;
    }
  }

  /**
   * With a digit: a value of nine bits is mirrored by the lowest bit, and rounded.
   *
   * @param step of a digit
   * @param offset of all bits but the lowest
   */
  Quantization(int bits, int base, int step, IntUnaryOperator offset) {
    this.bits = bits;
    this.base = base;
    values = new int[base << bits];
    for (int stored = 0; stored < values.length; stored++) {
      int mirror = (stored & 1) * 0x1ff;
      int high = (stored & (1 << bits) - 1) >> 1;
      int value = (stored >> bits) * step + offset.applyAsInt(high) ^ mirror;
      values[stored] = mirror & 0x80 | value >> 2;
    }
  }

  /** Returns the number of bits besides the digit. */
  int bits() {
    return bits;
  }

  /** Returns the base of the digit: 1 without one, 3 or 5. */
  int base() {
    return base;
  }

  /** Returns the value of a digit, in the high bits, and bits. */
  int value(int stored) {
    return values[stored];
  }
}
