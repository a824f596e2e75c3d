package io.github.lumbre.image.format.zstd;

import io.github.lumbre.image.ImageFormatException;
import java.util.Arrays;

/**
 * A table of finite state entropy: each state stands for a symbol, and for how to find the next
 * state (RFC 8878, section 4.1). Immutable.
 *
 * @param bits of the first state
 * @param symbols by state
 * @param widths bits to read for the next state, by state
 * @param bases of the next state, to which the bits are added, by state
 */
record EntropyTable(int bits, byte[] symbols, byte[] widths, short[] bases) {
  private static final int MIN_BITS = 5;

  /** In place of a number of states: the symbol has one, for less than one state of probability. */
  private static final int RARE = -1;

  /** Returns a table whose only symbol needs no bits. */
  static EntropyTable of(int symbol) {
    return new EntropyTable(0, new byte[] {(byte) symbol}, new byte[1], new short[1]);
  }

  /**
   * Returns the table of a distribution.
   *
   * @param counts states by symbol, {@link #RARE} included; 2^bits in total
   */
  static EntropyTable of(int bits, int... counts) {
    int size = 1 << bits;
    byte[] symbols = new byte[size];
    int high = size;
    for (int symbol = 0; symbol < counts.length; symbol++) {
      if (counts[symbol] == RARE) {
        symbols[--high] = (byte) symbol;
      }
    }
    int step = (size >> 1) + (size >> 3) + 3;
    int state = 0;
    for (int symbol = 0; symbol < counts.length; symbol++) {
      for (int i = 0; i < counts[symbol]; i++) {
        symbols[state] = (byte) symbol;
        do {
          state = state + step & size - 1;
        } while (state >= high);
      }
    }
    return withTransitions(bits, symbols, counts);
  }

  private static EntropyTable withTransitions(int bits, byte[] symbols, int... counts) {
    byte[] widths = new byte[symbols.length];
    short[] bases = new short[symbols.length];
    int[] next = new int[counts.length];
    for (int i = 0; i < next.length; i++) {
      next[i] = Math.abs(counts[i]);
    }
    for (int state = 0; state < symbols.length; state++) {
      int number = next[symbols[state]]++;
      int width = bits - (Integer.SIZE - 1 - Integer.numberOfLeadingZeros(number));
      widths[state] = (byte) width;
      bases[state] = (short) ((number << width) - symbols.length);
    }
    return new EntropyTable(bits, symbols, widths, bases);
  }

  /**
   * Reads a distribution.
   *
   * @param maxBits the largest number of bits of a state
   * @param maxSymbol the largest symbol
   */
  static EntropyTable read(ZstdInput in, int maxBits, int maxSymbol) throws ImageFormatException {
    ForwardBits source = new ForwardBits(in);
    int bits = source.read(4) + MIN_BITS;
    if (bits > maxBits) {
      throw in.malformed("expected states of at most " + maxBits + " bits, found " + bits);
    }
    int[] counts = new int[maxSymbol + 1];
    int left = 1 << bits;
    int symbol = 0;
    while (left > 0) {
      if (symbol > maxSymbol) {
        throw in.malformed("expected symbols up to " + maxSymbol + ", found more");
      }
      int count = count(source, left);
      counts[symbol++] = count;
      left -= Math.abs(count);
      for (int zeros = 3; count == 0 && zeros == 3; symbol += zeros) {
        zeros = source.read(2);
      }
    }
    source.finish();
    return of(bits, Arrays.copyOf(counts, Math.min(symbol, counts.length)));
  }

  /** Returns a number of states from {@link #RARE} to those that are left. */
  private static int count(ForwardBits source, int left) throws ImageFormatException {
    int width = Integer.SIZE - Integer.numberOfLeadingZeros(left + 1);
    int half = 1 << width - 1;
    // So many values need one bit less than the others.
    int shorter = 2 * half - 2 - left;
    int value = source.read(width - 1);
    if (value >= shorter) {
      value |= source.read(1) << width - 1;
      value -= value >= half ? shorter : 0;
    }
    return value - 1;
  }

  /** Bits that are read from front to back, the lowest of a byte first. Mutable. */
  private static final class ForwardBits {
    private final ZstdInput in;
    private int buffer;
    private int buffered;

    ForwardBits(ZstdInput in) {
      this.in = in;
    }

    int read(int count) throws ImageFormatException {
      while (buffered < count) {
        buffer |= in.unsignedByte() << buffered;
        buffered += Byte.SIZE;
      }
      int value = buffer & (1 << count) - 1;
      buffer >>>= count;
      buffered -= count;
      return value;
    }

    /** Forgets the rest of the last byte. */
    void finish() {
      buffered = 0;
    }
  }

  /** Returns the first state of a stream. */
  int first(BackwardBits source) {
    return source.read(bits);
  }

  /** Returns the state after another. */
  int next(int state, BackwardBits source) {
    return bases[state] + source.read(widths[state]);
  }
}
