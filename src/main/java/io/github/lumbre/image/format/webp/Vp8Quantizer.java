package io.github.lumbre.image.format.webp;

/**
 * The factors of the coefficients of a segment (RFC 6386, sec. 9.6 and 14.1): of the first one and
 * of the others, for luma, for the first coefficients of 16 luma blocks, and for chroma.
 */
record Vp8Quantizer(int lumaDc, int lumaAc, int meanDc, int meanAc, int chromaDc, int chromaAc) {
  private static final int MAX_INDEX = 127;
  private static final int MAX_CHROMA_INDEX = 117;

  /**
   * Returns the factors of a segment.
   *
   * @param index of the factor of luma that is not the first, which need not be in the tables
   * @param offsets the differences from this index, of the first factor of luma, of both of means
   *     and of both of chroma
   */
  static Vp8Quantizer of(int index, int[] offsets) {
    return new Vp8Quantizer(
        factor(Vp8Tables.DC_FACTORS, index + offsets[0], MAX_INDEX),
        factor(Vp8Tables.AC_FACTORS, index, MAX_INDEX),
        2 * factor(Vp8Tables.DC_FACTORS, index + offsets[1], MAX_INDEX),
        Math.max(8, factor(Vp8Tables.AC_FACTORS, index + offsets[2], MAX_INDEX) * 155 / 100),
        factor(Vp8Tables.DC_FACTORS, index + offsets[3], MAX_CHROMA_INDEX),
        factor(Vp8Tables.AC_FACTORS, index + offsets[4], MAX_INDEX));
  }

  private static int factor(int[] table, int index, int max) {
    return table[Math.max(0, Math.min(max, index))];
  }
}
