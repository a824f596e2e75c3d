package io.github.lumbre.image.format.ktx;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.internal.LowBits;

/** Reads numbers of a few bits from a part of a file. Mutable. */
final class BasisBits extends LowBits {
  private static final String DAMAGED = "KTX is damaged: ";

  private final String name;

  BasisBits(KtxInput in) {
    super(
        in.file(),
        in.from(),
        in.from() + in.size(),
        DAMAGED + in.name() + " ends after " + in.size() + " bytes");
    name = in.name();
  }

  /**
   * Returns a number of 32 bits in chunks, the lowest first; a bit after each chunk states whether
   * more follow.
   */
  long readChunks(int bits) throws ImageFormatException {
    long value = 0;
    for (int shift = 0; shift < Integer.SIZE; shift += bits) {
      int chunk = read(bits + 1);
      value |= (chunk & (1L << bits) - 1) << shift;
      if (chunk >> bits == 0) {
        return value;
      }
    }
    throw damaged("has a number of more than 32 bits");
  }

  ImageFormatException damaged(String problem) {
    return malformed(DAMAGED + name + " " + problem);
  }
}
