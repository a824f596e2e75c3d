package io.github.lumbre.model.draco;

import io.github.lumbre.model.ModelFormatException;

/** Symbols of one or three bits. Mutable. */
final class StandardSymbols implements Symbols {
  private final BitReader bits;

  private StandardSymbols(BitReader bits) {
    this.bits = bits;
  }

  /** Reads the bytes of all symbols. */
  static StandardSymbols read(DracoInput input, int count) throws ModelFormatException {
    int size = input.count("bytes of symbols", input.remaining());
    if (count > (long) Byte.SIZE * size) {
      throw input.malformed("expected " + count + " symbols, found " + size + " bytes of them");
    }
    int from = input.skip(size);
    return new StandardSymbols(new BitReader(input.bytes(), from, from + size));
  }

  @Override
  public int next() {
    return bits.read(1) == 0 ? CENTER : SPLIT + bits.read(2);
  }
}
