package io.github.lumbre.image.format.zstd;

import io.github.lumbre.image.ImageFormatException;
import java.util.Optional;

/**
 * One of the three numbers of a sequence. Its code, which is a symbol of a state, stands for a
 * base; bits that follow are added (RFC 8878, section 3.1.1.3.2.1). Mutable.
 */
final class SequenceNumber {
  private static final int PREDEFINED = 0;
  private static final int SINGLE = 1;
  private static final int COMPRESSED = 2;

  private final EntropyTable predefined;
  private final int maxTableBits;
  private final long[] bases;
  private final int[] widths;

  private Optional<EntropyTable> last = Optional.empty();
  private EntropyTable table;
  private int state;

  /**
   * @param base of the first code; each other one follows the values of the code before it
   * @param widths bits that follow, by code
   */
  private SequenceNumber(EntropyTable predefined, int maxTableBits, int base, int... widths) {
    this.predefined = predefined;
    this.maxTableBits = maxTableBits;
    this.widths = widths;
    table = predefined;
    bases = new long[widths.length];
    long next = base;
    for (int i = 0; i < widths.length; i++) {
      bases[i] = next;
      next += 1L << widths[i];
    }
  }

  static SequenceNumber literalLengths() {
    int[] counts = {
      4, 3, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 2, 1, 1, 1, 1,
      1, -1, -1, -1, -1
    };
    int[] widths = {
      0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 3, 3, 4, 6, 7, 8, 9, 10, 11,
      12, 13, 14, 15, 16
    };
    return new SequenceNumber(EntropyTable.of(6, counts), 9, 0, widths);
  }

  static SequenceNumber matchLengths() {
    int[] counts = {
      1, 4, 3, 2, 2, 2, 2, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
      1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, -1, -1, -1, -1, -1, -1, -1
    };
    int[] widths = {
      0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
      0, 1, 1, 1, 1, 2, 2, 3, 3, 4, 4, 5, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16
    };
    return new SequenceNumber(EntropyTable.of(6, counts), 9, 3, widths);
  }

  static SequenceNumber offsets() {
    int[] counts = {
      1, 1, 1, 1, 1, 1, 2, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, -1, -1, -1, -1, -1
    };
    int[] widths = new int[32];
    for (int i = 0; i < widths.length; i++) {
      widths[i] = i;
    }
    return new SequenceNumber(EntropyTable.of(5, counts), 8, 1, widths);
  }

  /**
   * Reads the table of a block.
   *
   * @param mode in [0, 4): where the table comes from
   */
  void readTable(ZstdInput in, int mode) throws ImageFormatException {
    switch (mode) {
      case PREDEFINED -> table = predefined;
      case SINGLE -> table = EntropyTable.of(code(in));
      case COMPRESSED -> table = EntropyTable.read(in, maxTableBits, widths.length - 1);
      default ->
          table = last.orElseThrow(() -> in.malformed("expected a table to repeat, found none"));
    }
    last = Optional.of(table);
  }

  private int code(ZstdInput in) throws ImageFormatException {
    int code = in.unsignedByte();
    if (code >= widths.length) {
      throw in.malformed("expected a code below " + widths.length + ", found " + code);
    }
    return code;
  }

  /** Reads the first state of a block. */
  void start(BackwardBits source) {
    state = table.first(source);
  }

  /** Reads the next state. */
  void advance(BackwardBits source) {
    state = table.next(state, source);
  }

  /** Reads the number of the present state. */
  long value(BackwardBits source) {
    int code = table.symbols()[state];
    return bases[code] + (source.read(widths[code]) & 0xffffffffL);
  }
}
