package io.github.lumbre.image.webp;

import io.github.lumbre.image.ImageFormatException;

/**
 * The factors of the coefficients of a segment (RFC 6386, sec. 9.6 and 14.1): of the first one and
 * of the others, for luma, for the first coefficients of 16 luma blocks, and for chroma.
 */
record Vp8Quantizer(int lumaDc, int lumaAc, int meanDc, int meanAc, int chromaDc, int chromaAc) {
  private static final int MAX_INDEX = 127;
  private static final int MAX_CHROMA_INDEX = 117;

  /** The differences of the indices of five factors from the index of luma. */
  record Offsets(int lumaDc, int meanDc, int meanAc, int chromaDc, int chromaAc) {
    static Offsets read(BoolDecoder bits) throws ImageFormatException {
      return new Offsets(
          bits.optional(4), bits.optional(4), bits.optional(4), bits.optional(4), bits.optional(4));
    }
  }

  /** Returns the factors of a segment with an index, which need not be in the tables. */
  static Vp8Quantizer of(int index, Offsets offsets) {
    return new Vp8Quantizer(
        factor(Vp8Tables.DC_FACTORS, index + offsets.lumaDc, MAX_INDEX),
        factor(Vp8Tables.AC_FACTORS, index, MAX_INDEX),
        2 * factor(Vp8Tables.DC_FACTORS, index + offsets.meanDc, MAX_INDEX),
        Math.max(8, factor(Vp8Tables.AC_FACTORS, index + offsets.meanAc, MAX_INDEX) * 155 / 100),
        factor(Vp8Tables.DC_FACTORS, index + offsets.chromaDc, MAX_CHROMA_INDEX),
        factor(Vp8Tables.AC_FACTORS, index + offsets.chromaAc, MAX_INDEX));
  }

  private static int factor(int[] table, int index, int max) {
    return table[Math.max(0, Math.min(max, index))];
  }
}
