package io.github.lumbre.image.format.webp;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.internal.LowBits;
import java.util.Arrays;

/**
 * The prefix codes of a group of pixels (RFC 9649, sec. 3.7.2): of green and the lengths of copies,
 * of the other channels, and of distances. Immutable.
 */
record PrefixCodes(
    PrefixCode green, PrefixCode red, PrefixCode blue, PrefixCode alpha, PrefixCode distance) {
  /** The number of values of a channel. */
  static final int LITERALS = 256;

  /** The number of codes for the lengths of copies. */
  static final int LENGTHS = 24;

  private static final int DISTANCES = 40;

  /** The order in which the lengths of the codes for lengths are stored. */
  private static final int[] ORDER = {
    17, 18, 0, 1, 2, 3, 4, 5, 16, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15
  };

  private static final int REPEAT_LAST = 16;
  private static final int[] REPEAT_BITS = {2, 3, 7};
  private static final int[] REPEAT_LEAST = {3, 3, 11};

  /**
   * Reads the codes of a group.
   *
   * @param cached the number of colors of the cache
   */
  static PrefixCodes read(LowBits bits, int cached) throws ImageFormatException {
    return new PrefixCodes(
        code(bits, LITERALS + LENGTHS + cached),
        code(bits, LITERALS),
        code(bits, LITERALS),
        code(bits, LITERALS),
        code(bits, DISTANCES));
  }

  /** Returns the number of entries of the tables, two bytes each. */
  int entries() {
    return green.entries() + red.entries() + blue.entries() + alpha.entries() + distance.entries();
  }

  private static PrefixCode code(LowBits bits, int symbols) throws ImageFormatException {
    int[] lengths = new int[symbols];
    if (bits.flag()) {
      boolean hasTwo = bits.flag();
      int first = bits.read(bits.flag() ? 8 : 1);
      int second = hasTwo ? bits.read(8) : first;
      if (Math.max(first, second) >= symbols) {
        throw malformed("WebP is damaged: a prefix code has an unknown symbol");
      }
      lengths[first] = 1;
      lengths[second] = 1;
    } else {
      readLengths(bits, lengths);
    }
    return PrefixCode.of(lengths);
  }

  private static void readLengths(LowBits bits, int[] lengths) throws ImageFormatException {
    int[] lengthsOfLengths = new int[ORDER.length];
    int count = 4 + bits.read(4);
    for (int i = 0; i < count; i++) {
      lengthsOfLengths[ORDER[i]] = bits.read(3);
    }
    PrefixCode code = PrefixCode.of(lengthsOfLengths);
    int left = lengths.length;
    if (bits.flag()) {
      left = 2 + bits.read(2 + 2 * bits.read(3));
    }
    if (left > lengths.length) {
      throw tooMany();
    }
    int last = 8;
    for (int i = 0; i < lengths.length && left > 0; left--) {
      int symbol = code.read(bits);
      if (symbol < REPEAT_LAST) {
        lengths[i++] = symbol;
        last = symbol == 0 ? last : symbol;
        continue;
      }
      int kind = symbol - REPEAT_LAST;
      int end = i + REPEAT_LEAST[kind] + bits.read(REPEAT_BITS[kind]);
      if (end > lengths.length) {
        throw tooMany();
      }
      Arrays.fill(lengths, i, end, kind == 0 ? last : 0);
      i = end;
    }
  }

  private static ImageFormatException tooMany() {
    return malformed("WebP is damaged: a prefix code has too many lengths");
  }
}
