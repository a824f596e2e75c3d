package io.github.lumbre.image.format.webp;

import io.github.lumbre.image.ImageFormatException;
import java.util.Arrays;

/**
 * The modes of a macroblock, and the modes around it, on which their probabilities depend (RFC
 * 6386, sec. 10, 11 and 19.3). Mutable.
 */
final class Vp8Modes {
  /** Predicts the mean of the neighbors. */
  static final int DC = 0;

  /** Predicts the sum of left and upper neighbor minus the corner. */
  static final int TRUE_MOTION = 1;

  /** Predicts the upper neighbor. */
  static final int VERTICAL = 2;

  /** Predicts the left neighbor. */
  static final int HORIZONTAL = 3;

  private static final int MODES = 10;
  private static final int NODES = MODES - 1;

  /** The next node for each node and bit, or the complement of a mode. */
  private static final int[] TREE = {
    ~DC, 1, ~TRUE_MOTION, 2, ~VERTICAL, 3, 4, 6, ~HORIZONTAL, 5, ~4, ~5, ~6, 7, ~7, 8, ~8, ~9
  };

  private final Vp8Header header;
  private final BoolDecoder bits;
  private final int[] above;
  private final int[] left = new int[4];
  private final int[] blocks = new int[16];
  private int segment;
  private boolean skips;
  private boolean split;
  private int luma;
  private int chroma;

  /**
   * @param columns the number of macroblocks in a row
   */
  Vp8Modes(Vp8Header header, int columns) {
    this.header = header;
    this.bits = header.modes();
    above = new int[4 * columns];
  }

  void startRow() {
    Arrays.fill(left, DC);
  }

  /** Reads the modes of the next macroblock. */
  void read(int column) throws ImageFormatException {
    int[] probabilities = header.segmentProbabilities();
    if (probabilities.length > 0) {
      int half = bits.bit(probabilities[0]);
      segment = 2 * half + bits.bit(probabilities[1 + half]);
    }
    skips = header.skipping() >= 0 && bits.bit(header.skipping()) == 1;
    split = bits.bit(145) == 0;
    if (split) {
      readBlocks(4 * column);
    } else {
      luma =
          bits.bit(156) == 1
              ? bits.bit(128) == 1 ? TRUE_MOTION : HORIZONTAL
              : bits.bit(163) == 1 ? VERTICAL : DC;
      Arrays.fill(above, 4 * column, 4 * column + 4, luma);
      Arrays.fill(left, luma);
    }
    chroma =
        bits.bit(142) == 0
            ? DC
            : bits.bit(114) == 0 ? VERTICAL : bits.bit(183) == 1 ? TRUE_MOTION : HORIZONTAL;
  }

  private void readBlocks(int column) throws ImageFormatException {
    for (int block = 0; block < blocks.length; block++) {
      int x = column + block % 4;
      int y = block / 4;
      int probabilities = (above[x] * MODES + left[y]) * NODES;
      int node = 0;
      do {
        node = TREE[2 * node + bits.bit(Vp8Tables.MODE_PROBABILITIES[probabilities + node])];
      } while (node > 0);
      blocks[block] = above[x] = left[y] = ~node;
    }
  }

  /** Returns the number of the segment: 0 to 3. */
  int segment() {
    return segment;
  }

  /** Returns whether the macroblock has no coefficients. */
  boolean skips() {
    return skips;
  }

  /** Returns whether each 4×4 block of luma has a mode of its own. */
  boolean isSplit() {
    return split;
  }

  /** Returns the mode of the luma of the whole macroblock; undefined if it is split. */
  int luma() {
    return luma;
  }

  /** Returns the mode of a 4×4 block of luma; undefined unless the macroblock is split. */
  int block(int index) {
    return blocks[index];
  }

  int chroma() {
    return chroma;
  }
}
