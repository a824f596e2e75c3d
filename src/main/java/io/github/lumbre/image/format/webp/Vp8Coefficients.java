package io.github.lumbre.image.format.webp;

import io.github.lumbre.image.ImageFormatException;
import java.util.Arrays;

/**
 * The coefficients of a macroblock, and which blocks around it have any, on which their
 * probabilities depend (RFC 6386, sec. 13 and 14). Mutable.
 */
final class Vp8Coefficients {
  /** The number of coefficients in a block. */
  static final int BLOCK = 16;

  private static final int LUMA_BLOCKS = 16;
  private static final int BLOCKS = 24;

  /** The flags of a macroblock at one of its edges: 4 of luma, 2 and 2 of chroma, 1 of means. */
  private static final int FLAGS = 9;

  private static final int MEAN_FLAG = 8;

  private static final int LUMA_WITHOUT_MEAN = 0;
  private static final int MEANS = 1;
  private static final int CHROMA = 2;
  private static final int LUMA = 3;

  private static final int CONTEXTS = 3;
  private static final int NODES = 11;
  private static final int[] BANDS = {0, 1, 2, 3, 6, 4, 5, 6, 6, 6, 6, 6, 6, 6, 6, 7, 0};
  private static final int[] ZIGZAG = {0, 1, 4, 8, 5, 2, 3, 6, 9, 12, 13, 10, 7, 11, 14, 15};

  /** The probabilities of the extra bits of the four categories of large values. */
  private static final int[][] EXTRA_BITS = {
    {173, 148, 140},
    {176, 155, 140, 135},
    {180, 157, 141, 134, 130},
    {254, 254, 243, 230, 196, 177, 153, 140, 133, 130, 129}
  };

  private final int[] tokens;
  private final byte[] above;
  private final byte[] left = new byte[FLAGS];
  private final short[] values = new short[BLOCKS * BLOCK];
  private final short[] means = new short[BLOCK];
  private BoolDecoder bits;
  private boolean found;

  /**
   * @param columns the number of macroblocks in a row
   */
  Vp8Coefficients(Vp8Header header, int columns) {
    tokens = header.tokens();
    above = new byte[FLAGS * columns];
  }

  /** Starts a row whose coefficients are in a part of the data. */
  void startRow(BoolDecoder part) {
    bits = part;
    Arrays.fill(left, (byte) 0);
  }

  /** Returns the coefficients: 16 blocks of luma, then 4 of each chroma, row by row. */
  short[] values() {
    return values;
  }

  /**
   * Reads the coefficients of the next macroblock.
   *
   * @return whether there are any
   */
  boolean read(int column, Vp8Modes modes, Vp8Quantizer quantizer) throws ImageFormatException {
    Arrays.fill(values, (short) 0);
    int up = FLAGS * column;
    if (modes.skips()) {
      int count = modes.isSplit() ? MEAN_FLAG : FLAGS;
      Arrays.fill(above, up, up + count, (byte) 0);
      Arrays.fill(left, 0, count, (byte) 0);
      return false;
    }
    found = false;
    if (modes.isSplit()) {
      readBlocks(LUMA, up, 0, 4, 0, quantizer.lumaDc(), quantizer.lumaAc());
    } else {
      readMeans(up, quantizer);
      readBlocks(LUMA_WITHOUT_MEAN, up, 0, 4, 0, quantizer.lumaDc(), quantizer.lumaAc());
    }
    for (int plane = 0; plane < 2; plane++) {
      int flag = 4 + 2 * plane;
      int block = LUMA_BLOCKS + 4 * plane;
      readBlocks(CHROMA, up, flag, 2, block, quantizer.chromaDc(), quantizer.chromaAc());
    }
    return found;
  }

  private void readMeans(int up, Vp8Quantizer quantizer) throws ImageFormatException {
    Arrays.fill(means, (short) 0);
    int context = above[up + MEAN_FLAG] + left[MEAN_FLAG];
    int end = readBlock(MEANS, context, 0, means, 0, quantizer.meanDc(), quantizer.meanAc());
    above[up + MEAN_FLAG] = left[MEAN_FLAG] = (byte) (end > 0 ? 1 : 0);
    Vp8Transform.spreadMeans(means, values);
  }

  private void readBlocks(int type, int up, int flag, int side, int first, int dc, int ac)
      throws ImageFormatException {
    int start = type == LUMA_WITHOUT_MEAN ? 1 : 0;
    for (int i = 0; i < side * side; i++) {
      int x = up + flag + i % side;
      int y = flag + i / side;
      int offset = (first + i) * BLOCK;
      int end = readBlock(type, above[x] + left[y], start, values, offset, dc, ac);
      above[x] = left[y] = (byte) (end > start ? 1 : 0);
      found |= end > 1 || values[offset] != 0;
    }
  }

  /** Reads a block; returns the number of the coefficient after the last one that was coded. */
  private int readBlock(int type, int context, int start, short[] to, int offset, int dc, int ac)
      throws ImageFormatException {
    int node = node(type, start, context);
    for (int i = start; i < BLOCK; i++) {
      if (bits.bit(tokens[node]) == 0) {
        return i;
      }
      while (bits.bit(tokens[node + 1]) == 0) {
        i++;
        if (i == BLOCK) {
          return BLOCK;
        }
        node = node(type, i, 0);
      }
      int magnitude = bits.bit(tokens[node + 2]) == 0 ? 1 : large(node);
      node = node(type, i + 1, magnitude == 1 ? 1 : 2);
      to[offset + ZIGZAG[i]] = (short) (bits.withSign(magnitude) * (i == 0 ? dc : ac));
    }
    return BLOCK;
  }

  private static int node(int type, int coefficient, int context) {
    return ((type * 8 + BANDS[coefficient]) * CONTEXTS + context) * NODES;
  }

  /** Returns a magnitude above 1. */
  private int large(int node) throws ImageFormatException {
    if (bits.bit(tokens[node + 3]) == 0) {
      return bits.bit(tokens[node + 4]) == 0 ? 2 : 3 + bits.bit(tokens[node + 5]);
    }
    if (bits.bit(tokens[node + 6]) == 0) {
      return bits.bit(tokens[node + 7]) == 0
          ? 5 + bits.bit(159)
          : 7 + 2 * bits.bit(165) + bits.bit(145);
    }
    int half = bits.bit(tokens[node + 8]);
    int category = 2 * half + bits.bit(tokens[node + 9 + half]);
    int extra = 0;
    for (int probability : EXTRA_BITS[category]) {
      extra = 2 * extra + bits.bit(probability);
    }
    return 3 + (8 << category) + extra;
  }
}
