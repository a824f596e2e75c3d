package io.github.lumbre.image.format.ktx;

import io.github.lumbre.image.ImageFormatException;

/**
 * The codes of slices (BasisLZ/ETC1S Bitstream Specification, ETC1S slice Huffman tables).
 *
 * @param predictions how four blocks find their colors
 * @param endpoints differences of indices of colors
 * @param selectors indices of selectors, or of recent ones
 * @param runs lengths of runs of selectors
 * @param recent the number of recent selectors
 */
record Etc1sTables(
    BasisCode predictions, BasisCode endpoints, BasisCode selectors, BasisCode runs, int recent) {
  private static final int RECENT_BITS = 13;

  static Etc1sTables read(BasisBits in) throws ImageFormatException {
    Etc1sTables tables =
        new Etc1sTables(
            BasisCode.read(in),
            BasisCode.read(in),
            BasisCode.read(in),
            BasisCode.read(in),
            in.read(RECENT_BITS));
    if (tables.recent == 0) {
      throw in.damaged("has no recent selectors");
    }
    return tables;
  }
}
