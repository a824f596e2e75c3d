package io.github.lumbre.model.format.draco;

import io.github.lumbre.model.ModelFormatException;
import java.util.Arrays;

/** Decodes symbols whose probabilities are in the stream. Mutable. */
final class RansSymbolDecoder {
  private static final int MIN_PRECISION_BITS = 12;
  private static final int MAX_PRECISION_BITS = 20;

  /** A byte of the table may stand for this number of symbols that do not occur. */
  private static final long MAX_SYMBOLS_PER_BYTE = 64;

  private final int precisionBits;
  private final int[] frequencies;

  /** The sums of the frequencies of the symbols before each. */
  private final int[] starts;

  /** The symbol of each remainder of a state. */
  private final int[] symbols;

  private final RansState state;

  private RansSymbolDecoder(DracoInput input, int precisionBits) throws ModelFormatException {
    this.precisionBits = precisionBits;
    int count = input.count("symbols", MAX_SYMBOLS_PER_BYTE * input.remaining());
    frequencies = input.integers(count);
    starts = input.integers(count);
    symbols = input.integers(1 << precisionBits);
    readFrequencies(input);
    fillTables(input);
    state = RansState.read(input, 4 << precisionBits);
  }

  /**
   * Reads the table of symbols, and the bytes of all coded symbols.
   *
   * @param symbolBits the length of the largest symbol in bits
   */
  static RansSymbolDecoder read(DracoInput input, int symbolBits) throws ModelFormatException {
    int bits = Math.max(MIN_PRECISION_BITS, Math.min(MAX_PRECISION_BITS, 3 * symbolBits / 2));
    return new RansSymbolDecoder(input, bits);
  }

  private void readFrequencies(DracoInput input) throws ModelFormatException {
    for (int i = 0; i < frequencies.length; i++) {
      int first = input.unsignedByte();
      int extra = first & 3;
      int frequency = first >> 2;
      if (extra == 3) {
        // A run of symbols that do not occur.
        i += frequency;
        if (i >= frequencies.length) {
          throw input.malformed(
              "expected " + frequencies.length + " symbols, found at least " + (i + 1));
        }
      } else {
        frequencies[i] = frequency | (int) input.integer(extra) << 6;
      }
    }
  }

  private void fillTables(DracoInput input) throws ModelFormatException {
    int sum = 0;
    for (int i = 0; i < frequencies.length; i++) {
      int end = sum + frequencies[i];
      if (end > symbols.length) {
        sum = end;
        break;
      }
      starts[i] = sum;
      Arrays.fill(symbols, sum, end, i);
      sum = end;
    }
    if (sum != symbols.length) {
      throw input.malformed(
          "expected frequencies with the sum " + symbols.length + ", found " + sum);
    }
  }

  /** Returns the next symbol; any after the last. */
  int next() {
    state.refill();
    int rest = state.value & symbols.length - 1;
    int symbol = symbols[rest];
    state.value = (state.value >>> precisionBits) * frequencies[symbol] + rest - starts[symbol];
    return symbol;
  }
}
