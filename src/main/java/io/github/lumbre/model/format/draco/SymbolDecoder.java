package io.github.lumbre.model.format.draco;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.model.ModelFormatException;

/** Decodes lists of unsigned integers. Stateless. */
final class SymbolDecoder {
  private static final int TAGGED = 0;
  private static final int RAW = 1;
  private static final int TAG_BITS = 5;
  private static final int MAX_SYMBOL_BITS = 18;
  private static final int INTERRUPT_MASK = (1 << 16) - 1;

  private SymbolDecoder() {}

  /**
   * Fills an array with symbols.
   *
   * @param components symbols of one length; a divisor of the number of symbols
   */
  static void decode(DracoInput input, int components, int... target) throws ModelFormatException {
    if (target.length == 0) {
      return;
    }
    int scheme = input.unsignedByte();
    switch (scheme) {
      case TAGGED -> decodeTagged(input, components, target);
      case RAW -> decodeRaw(input, target);
      default -> throw input.unsupported("expected tagged (0) or raw (1) symbols, found " + scheme);
    }
  }

  /** Decodes symbols as plain bits, whose numbers are coded. */
  private static void decodeTagged(DracoInput input, int components, int... target)
      throws ModelFormatException {
    RansSymbolDecoder lengths = RansSymbolDecoder.read(input, TAG_BITS);
    BitReader bits =
        new BitReader(input.bytes(), input.position(), input.position() + input.remaining());
    for (int i = 0; i < target.length; i += components) {
      if ((i & INTERRUPT_MASK) < components) {
        Interrupts.check();
      }
      int length = lengths.next();
      if (length > Integer.SIZE) {
        throw input.malformed("expected symbols of at most 32 bits, found " + length);
      }
      for (int c = 0; c < components; c++) {
        target[i + c] = bits.read(length);
      }
    }
    input.skip((long) bits.position() - input.position());
  }

  private static void decodeRaw(DracoInput input, int... target) throws ModelFormatException {
    int bits = input.unsignedByte();
    if (bits < 1 || bits > MAX_SYMBOL_BITS) {
      throw input.malformed("expected symbols of 1 to 18 bits, found " + bits);
    }
    RansSymbolDecoder symbols = RansSymbolDecoder.read(input, bits);
    for (int i = 0; i < target.length; i++) {
      if ((i & INTERRUPT_MASK) == 0) {
        Interrupts.check();
      }
      target[i] = symbols.next();
    }
  }

  /** Returns the signed integer that a symbol stands for: 0, -1, 1, -2, 2 and so on. */
  static int signed(int symbol) {
    return symbol >>> 1 ^ -(symbol & 1);
  }
}
