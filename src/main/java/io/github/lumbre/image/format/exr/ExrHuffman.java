package io.github.lumbre.image.format.exr;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.image.ImageFormatException;
import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * Decodes the canonical Huffman code of PIZ and DWA compression. Longer codes have smaller values.
 * One symbol stands for repetitions of the previous value. Not reusable.
 */
final class ExrHuffman {
  private static final int SYMBOLS = (1 << 16) + 1;
  private static final int MAX_LENGTH = 58;

  /** Lengths from here on stand for 2 to 5 symbols without a code, in a row. */
  private static final int SHORT_GAP = 59;

  /** This length stands for 6 or more symbols without a code, in a row; 8 bits state how many. */
  private static final int LONG_GAP = 63;

  private static final int SHORTEST_LONG_GAP = 6;

  /** The number of bits by which short codes are looked up. */
  private static final int LOOKUP_BITS = 12;

  private static final int LENGTH_BITS = 6;

  /** The values after which decoding notices interrupts. */
  private static final int INTERRUPT_VALUES = 1 << 20;

  private final ByteBuffer in;

  /** Symbols by length of their codes, and then by value. */
  private int[] symbols = {};

  /** For each length, the smallest code, the number of codes, and the place of its first symbol. */
  private final long[] first = new long[MAX_LENGTH + 1];

  private final int[] counts = new int[MAX_LENGTH + 1];
  private final int[] places = new int[MAX_LENGTH + 1];

  /** For the first bits, the symbol and the length of its code; 0 for longer codes. */
  private final int[] lookup = new int[1 << LOOKUP_BITS];

  /** Bits that have been read from bytes but not used, at the lower end. */
  private long bits;

  private int bitCount;
  private long bitsLeft;

  ExrHuffman(ByteBuffer in) {
    this.in = in;
  }

  /** Fills an array with decoded values. */
  void decode(short[] values) throws ImageFormatException {
    int firstSymbol = in.getInt();
    int lastSymbol = in.getInt();
    in.getInt();
    int codedBits = in.getInt();
    in.getInt();
    if (firstSymbol < 0 || firstSymbol > lastSymbol || lastSymbol >= SYMBOLS) {
      throw damaged();
    }
    bitsLeft = 8L * in.remaining();
    readCodes(firstSymbol, lastSymbol);
    bits = 0;
    bitCount = 0;
    if (codedBits < 0 || codedBits > 8L * in.remaining()) {
      throw damaged();
    }
    bitsLeft = codedBits;
    int size = 0;
    int checked = 0;
    while (size < values.length) {
      if (size >= checked) {
        Interrupts.check();
        checked = size + INTERRUPT_VALUES;
      }
      int symbol = nextSymbol();
      if (symbol != lastSymbol) {
        values[size++] = (short) symbol;
        continue;
      }
      int run = (int) next(8);
      if (size == 0 || run > values.length - size) {
        throw damaged();
      }
      for (int i = 0; i < run; i++) {
        values[size] = values[size - 1];
        size++;
      }
    }
    if (bitsLeft != 0) {
      throw damaged();
    }
  }

  private void readCodes(int firstSymbol, int lastSymbol) throws ImageFormatException {
    byte[] lengths = new byte[lastSymbol + 1];
    for (int symbol = firstSymbol; symbol <= lastSymbol; symbol++) {
      int length = (int) next(LENGTH_BITS);
      if (length < SHORT_GAP) {
        lengths[symbol] = (byte) length;
        counts[length]++;
        continue;
      }
      int gap = length == LONG_GAP ? (int) next(8) + SHORTEST_LONG_GAP : length - SHORT_GAP + 2;
      symbol += gap - 1;
      if (symbol > lastSymbol) {
        throw damaged();
      }
    }
    counts[0] = 0;
    assignCodes();
    sortSymbols(lengths);
    fillLookup();
  }

  private void assignCodes() throws ImageFormatException {
    long code = 0;
    for (int length = MAX_LENGTH; length > 0; length--) {
      first[length] = code;
      if (code + counts[length] > 1L << length) {
        throw damaged();
      }
      code = code + counts[length] >> 1;
    }
  }

  private void sortSymbols(byte[] lengths) {
    int total = 0;
    for (int length = 1; length <= MAX_LENGTH; length++) {
      places[length] = total;
      total += counts[length];
    }
    symbols = new int[total];
    int[] next = places.clone();
    for (int symbol = 0; symbol < lengths.length; symbol++) {
      if (lengths[symbol] > 0) {
        symbols[next[lengths[symbol]]++] = symbol;
      }
    }
  }

  private void fillLookup() {
    for (int length = 1; length <= LOOKUP_BITS; length++) {
      int rest = LOOKUP_BITS - length;
      for (int i = 0; i < counts[length]; i++) {
        int from = (int) (first[length] + i << rest);
        int entry = symbols[places[length] + i] << LENGTH_BITS | length;
        Arrays.fill(lookup, from, from + (1 << rest), entry);
      }
    }
  }

  private int nextSymbol() throws ImageFormatException {
    if (bitsLeft >= LOOKUP_BITS) {
      fetch(LOOKUP_BITS);
      int entry = lookup[(int) (bits >>> bitCount - LOOKUP_BITS) & (1 << LOOKUP_BITS) - 1];
      if (entry != 0) {
        next(entry & (1 << LENGTH_BITS) - 1);
        return entry >> LENGTH_BITS;
      }
    }
    long code = 0;
    for (int length = 1; length <= MAX_LENGTH; length++) {
      code = code << 1 | next(1);
      long place = code - first[length];
      if (place >= 0 && place < counts[length]) {
        return symbols[places[length] + (int) place];
      }
    }
    throw damaged();
  }

  /** Returns the next bits, at most 12. */
  private long next(int count) throws ImageFormatException {
    if (count > bitsLeft) {
      throw damaged();
    }
    fetch(count);
    bitsLeft -= count;
    bitCount -= count;
    return bits >>> bitCount & (1L << count) - 1;
  }

  private void fetch(int count) {
    while (bitCount < count) {
      bits = bits << 8 | in.get() & 0xff;
      bitCount += 8;
    }
  }

  private static ImageFormatException damaged() {
    return malformed("OpenEXR is damaged: a block cannot be unpacked");
  }
}
