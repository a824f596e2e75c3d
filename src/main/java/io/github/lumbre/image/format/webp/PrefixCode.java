package io.github.lumbre.image.format.webp;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.internal.LowBits;

/**
 * A canonical prefix code of the lossless format (RFC 9649, sec. 3.7.2). Immutable.
 *
 * @param table for each sequence of bits, the symbol, shifted by four, and the length of its code;
 *     0 for longer codes
 * @param symbols of the code, by the lengths of their codes, and then by their values
 * @param counts the number of codes of each length
 */
record PrefixCode(char[] table, char[] symbols, char[] counts) {
  private static final int MAX_LENGTH = 15;

  /** The longest codes that a table decodes; longer ones are decoded bit by bit. */
  private static final int TABLE_BITS = 8;

  /**
   * Returns the code with a length for each symbol, 0 for those that do not occur.
   *
   * @throws ImageFormatException unless there is a code for each sequence of bits; the code of a
   *     single symbol is empty
   */
  static PrefixCode of(int[] lengths) throws ImageFormatException {
    char[] counts = new char[MAX_LENGTH + 1];
    int used = 0;
    int longest = 0;
    for (int length : lengths) {
      counts[length]++;
      used += length > 0 ? 1 : 0;
      longest = Math.max(longest, length);
    }
    counts[0] = 0;
    char[] symbols = sorted(lengths, counts, used);
    if (used == 1) {
      return new PrefixCode(new char[] {(char) (symbols[0] << 4)}, symbols, counts);
    }
    int free = 1;
    for (int length = 1; length <= MAX_LENGTH && free >= 0; length++) {
      free = 2 * free - counts[length];
    }
    if (free != 0) {
      throw malformed("WebP is damaged: a prefix code is not complete");
    }
    return new PrefixCode(table(symbols, counts, longest), symbols, counts);
  }

  private static char[] sorted(int[] lengths, char[] counts, int used) {
    int[] next = new int[MAX_LENGTH + 1];
    for (int length = 1; length < MAX_LENGTH; length++) {
      next[length + 1] = next[length] + counts[length];
    }
    char[] symbols = new char[used];
    for (int symbol = 0; symbol < lengths.length; symbol++) {
      if (lengths[symbol] > 0) {
        symbols[next[lengths[symbol]]++] = (char) symbol;
      }
    }
    return symbols;
  }

  private static char[] table(char[] symbols, char[] counts, int longest) {
    int bits = Math.min(TABLE_BITS, longest);
    char[] table = new char[1 << bits];
    int code = 0;
    int i = 0;
    for (int length = 1; length <= bits; length++, code <<= 1) {
      for (int end = i + counts[length]; i < end; i++, code++) {
        int first = Integer.reverse(code) >>> Integer.SIZE - length;
        for (int entry = first; entry < table.length; entry += 1 << length) {
          table[entry] = (char) (symbols[i] << 4 | length);
        }
      }
    }
    return table;
  }

  /** Returns the number of entries of the tables, two bytes each. */
  int entries() {
    return table.length + symbols.length + counts.length;
  }

  /** Returns the next symbol. */
  int read(LowBits bits) throws ImageFormatException {
    int ahead = bits.peek(MAX_LENGTH);
    int entry = table[ahead & table.length - 1];
    int length = entry & 0xf;
    if (length == 0 && symbols.length > 1) {
      return readLong(bits, ahead);
    }
    bits.skip(length);
    return entry >> 4;
  }

  private int readLong(LowBits bits, int ahead) throws ImageFormatException {
    int code = 0;
    int first = 0;
    int index = 0;
    int length = 0;
    do {
      index += counts[length];
      first = first + counts[length] << 1;
      code = code << 1 | ahead >> length & 1;
      length++;
    } while (code - first >= counts[length]);
    bits.skip(length);
    return symbols[index + code - first];
  }
}
