package io.github.lumbre.image.format.zstd;

import io.github.lumbre.image.ImageFormatException;
import java.util.Arrays;

/**
 * A Huffman code of bytes (RFC 8878, section 4.2). Immutable.
 *
 * @param bits of the longest code
 * @param symbols by the next {@link #bits} of a stream
 * @param widths of the code that begins with these bits
 */
record LiteralCode(int bits, byte[] symbols, byte[] widths) {
  private static final int MAX_BITS = 11;
  private static final int MAX_WEIGHT_STATE_BITS = 6;
  private static final int MAX_SYMBOLS = 256;

  /** The first byte of weights that are stored in four bits each, for no weight. */
  private static final int DIRECT = 127;

  /** Reads the weights of all symbols but the last. */
  static LiteralCode read(ZstdInput in) throws ImageFormatException {
    byte[] weights = new byte[MAX_SYMBOLS];
    int header = in.unsignedByte();
    int count = header - DIRECT;
    if (header > DIRECT) {
      int from = in.skip((count + 1) / 2);
      for (int i = 0; i < count; i++) {
        int pair = in.bytes()[from + i / 2];
        weights[i] = (byte) (i % 2 == 0 ? pair >> 4 & 0xf : pair & 0xf);
      }
    } else {
      count = readCompressed(in.part(header), weights);
    }
    return of(in, weights, count);
  }

  /** Reads weights in turns by two states of one table; returns their number. */
  private static int readCompressed(ZstdInput in, byte... weights) throws ImageFormatException {
    EntropyTable table = EntropyTable.read(in, MAX_WEIGHT_STATE_BITS, MAX_BITS + 1);
    BackwardBits source = new BackwardBits(in);
    int state = table.first(source);
    int other = table.first(source);
    int count = 0;
    while (!source.isExceeded()) {
      if (count > MAX_SYMBOLS - 3) {
        throw in.malformed("expected at most 255 weights, found more");
      }
      weights[count++] = table.symbols()[state];
      int next = table.next(state, source);
      state = other;
      other = next;
    }
    weights[count++] = table.symbols()[state];
    return count;
  }

  /**
   * Returns the code of weights: a symbol of weight w &gt; 0 has a share of 2^w of all bits, and
   * the last symbol has the share that is left.
   */
  private static LiteralCode of(ZstdInput in, byte[] weights, int count)
      throws ImageFormatException {
    int sum = 0;
    for (int i = 0; i < count; i++) {
      sum += 1 << weights[i] >> 1;
    }
    int bits = Integer.SIZE - Integer.numberOfLeadingZeros(sum);
    int rest = (1 << bits) - sum;
    if (sum == 0 || bits > MAX_BITS || Integer.bitCount(rest) != 1) {
      throw in.malformed(
          "expected weights of a code of at most " + MAX_BITS + " bits, found the sum " + sum);
    }
    weights[count] = (byte) (Integer.numberOfTrailingZeros(rest) + 1);
    return of(bits, Arrays.copyOf(weights, count + 1));
  }

  private static LiteralCode of(int bits, byte... weights) {
    byte[] symbols = new byte[1 << bits];
    byte[] widths = new byte[1 << bits];
    int at = 0;
    for (int weight = 1; weight <= bits; weight++) {
      for (int symbol = 0; symbol < weights.length; symbol++) {
        if (weights[symbol] == weight) {
          int next = at + (1 << weight - 1);
          Arrays.fill(symbols, at, next, (byte) symbol);
          Arrays.fill(widths, at, next, (byte) (bits + 1 - weight));
          at = next;
        }
      }
    }
    return new LiteralCode(bits, symbols, widths);
  }

  /** Decodes a stream of a known number of bytes. */
  void decode(ZstdInput in, byte[] target, int from, int end) throws ImageFormatException {
    BackwardBits source = new BackwardBits(in);
    for (int i = from; i < end; i++) {
      int next = source.peek(bits);
      target[i] = symbols[next];
      source.skip(widths[next]);
    }
    source.requireEnd();
  }
}
