package io.github.lumbre.image.format.ktx;

import io.github.lumbre.image.ImageFormatException;
import java.util.Arrays;

/**
 * A canonical Huffman code (KTX File Format 2.0, BasisLZ/ETC1S Bitstream Specification, compressed
 * Huffman tables). Immutable.
 */
final class BasisCode {
  private static final int COUNT_BITS = 14;
  private static final int MAX_WIDTH = 16;

  /** The order of the widths of the code of widths. */
  private static final int[] ORDER = {
    17, 18, 19, 20, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15, 16
  };

  private static final int SHORT_ZEROS = 17;
  private static final int LONG_ZEROS = 18;
  private static final int SHORT_REPEAT = 19;

  private static final int WIDTH_BITS = 5;
  private static final int WIDTH_MASK = (1 << WIDTH_BITS) - 1;

  private final int maxWidth;

  /** Symbols and widths, by the next bits of a stream; 0 for bits without a symbol. */
  private final int[] entries;

  private BasisCode(int maxWidth) {
    this.maxWidth = maxWidth;
    entries = new int[1 << maxWidth];
  }

  /** Reads a code. One without symbols can be read, and not used. */
  static BasisCode read(BasisBits in) throws ImageFormatException {
    int count = in.read(COUNT_BITS);
    if (count == 0) {
      return new BasisCode(0);
    }
    int stored = in.read(5);
    if (stored < 1 || stored > ORDER.length) {
      throw in.damaged("has %d widths of widths, expected 1 to 21".formatted(stored));
    }
    int[] widths = new int[ORDER.length];
    for (int i = 0; i < stored; i++) {
      widths[ORDER[i]] = in.read(3);
    }
    return of(in, readWidths(in, of(in, widths), count));
  }

  private static int[] readWidths(BasisBits in, BasisCode code, int count)
      throws ImageFormatException {
    int[] widths = new int[count];
    int at = 0;
    while (at < count) {
      int symbol = code.decode(in);
      if (symbol <= MAX_WIDTH) {
        widths[at++] = symbol;
        continue;
      }
      int run =
          switch (symbol) {
            case SHORT_ZEROS -> 3 + in.read(3);
            case LONG_ZEROS -> 11 + in.read(7);
            case SHORT_REPEAT -> 3 + in.read(2);
            default -> 7 + in.read(7);
          };
      int repeated = symbol < SHORT_REPEAT || at == 0 ? 0 : widths[at - 1];
      if (run > count - at || symbol >= SHORT_REPEAT && repeated == 0) {
        throw in.damaged("has a run of %d widths at %d of %d".formatted(run, at, count));
      }
      for (int end = at + run; at < end; at++) {
        widths[at] = repeated;
      }
    }
    return widths;
  }

  private static BasisCode of(BasisBits in, int... widths) throws ImageFormatException {
    int[] counts = new int[MAX_WIDTH + 1];
    int maxWidth = 0;
    for (int width : widths) {
      counts[width]++;
      maxWidth = Math.max(maxWidth, width);
    }
    counts[0] = 0;
    int[] next = new int[MAX_WIDTH + 2];
    for (int width = 1; width <= MAX_WIDTH; width++) {
      next[width + 1] = next[width] + counts[width] << 1;
    }
    if (next[MAX_WIDTH + 1] != 2 << MAX_WIDTH && Arrays.stream(counts).sum() != 1) {
      throw in.damaged("has a Huffman code that is not complete");
    }
    BasisCode code = new BasisCode(maxWidth);
    for (int symbol = 0; symbol < widths.length; symbol++) {
      if (widths[symbol] > 0) {
        code.add(symbol, widths[symbol], next[widths[symbol]]++);
      }
    }
    return code;
  }

  private void add(int symbol, int width, int bits) {
    int reversed = Integer.reverse(bits) >>> Integer.SIZE - width;
    for (int i = reversed; i < entries.length; i += 1 << width) {
      entries[i] = symbol << WIDTH_BITS | width;
    }
  }

  /** Returns the next symbol of a stream. */
  int decode(BasisBits in) throws ImageFormatException {
    int entry = entries[in.peek(maxWidth)];
    if (entry == 0) {
      throw in.damaged("has bits that are not in its Huffman code");
    }
    in.skip(entry & WIDTH_MASK);
    return entry >> WIDTH_BITS;
  }
}
