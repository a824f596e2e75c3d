package io.github.lumbre.image.format.ktx;

/**
 * A mode of UASTC: how the bits of a block are used (UASTC LDR 4x4 Texture Specification). Tables
 * of numbers are those of the Basis Universal transcoder.
 *
 * @param code the first bits of a block
 * @param codeBits their number
 * @param hintBits bits for transcoders to other formats, which are skipped
 * @param weightBits bits of a weight
 * @param endpoints how the ends of color ranges are stored
 * @param subsets color ranges
 * @param planes weights of a texel: 2 if one channel has a weight of its own
 * @param channels 2 for luminance and alpha, 3 for colors, 4 with alpha
 */
record UastcMode(
    int code,
    int codeBits,
    int hintBits,
    int weightBits,
    Quantization endpoints,
    int subsets,
    int planes,
    int channels) {
  /** The mode of blocks of one color; its other numbers have no meaning. */
  static final UastcMode SOLID = new UastcMode(0x17, 5, 0, 0, Quantization.BITS_8, 1, 1, 4);

  private static final UastcMode THREE =
      new UastcMode(0x03, 5, 15, 2, Quantization.TRIT_2, 3, 1, 3);

  /** The mode of two subsets whose patterns come from those of three. */
  private static final UastcMode MERGED =
      new UastcMode(0x07, 5, 15, 2, Quantization.QUINT_3, 2, 1, 3);

  private static final UastcMode[] ALL = {
    new UastcMode(0x01, 4, 15, 4, Quantization.TRIT_6, 1, 1, 3),
    new UastcMode(0x35, 6, 15, 2, Quantization.BITS_8, 1, 1, 3),
    new UastcMode(0x1d, 5, 15, 3, Quantization.BITS_4, 2, 1, 3),
    THREE,
    new UastcMode(0x13, 5, 15, 2, Quantization.QUINT_3, 2, 1, 3),
    new UastcMode(0x0b, 5, 15, 3, Quantization.BITS_8, 1, 1, 3),
    new UastcMode(0x1b, 5, 15, 2, Quantization.QUINT_5, 1, 2, 3),
    MERGED,
    SOLID,
    new UastcMode(0x0f, 5, 23, 2, Quantization.BITS_4, 2, 1, 4),
    new UastcMode(0x02, 3, 17, 4, Quantization.TRIT_4, 1, 1, 4),
    new UastcMode(0x00, 2, 17, 2, Quantization.TRIT_4, 1, 2, 4),
    new UastcMode(0x06, 3, 17, 3, Quantization.TRIT_6, 1, 1, 4),
    new UastcMode(0x1f, 5, 23, 1, Quantization.BITS_8, 1, 2, 4),
    new UastcMode(0x0d, 5, 23, 2, Quantization.BITS_8, 1, 1, 4),
    new UastcMode(0x05, 7, 23, 4, Quantization.BITS_8, 1, 1, 2),
    new UastcMode(0x15, 6, 23, 2, Quantization.BITS_8, 2, 1, 2),
    new UastcMode(0x25, 6, 23, 2, Quantization.BITS_8, 1, 2, 2),
    new UastcMode(0x09, 4, 15, 5, Quantization.BITS_5, 1, 1, 3)
  };

  private static final int MAX_CODE_BITS = 7;

  /** Modes by the first bits of a block; null for the one code that has no mode. */
  private static final UastcMode[] BY_CODE = new UastcMode[1 << MAX_CODE_BITS];

  static {
    for (UastcMode mode : ALL) {
      for (int bits = mode.code; bits < BY_CODE.length; bits += 1 << mode.codeBits) {
        BY_CODE[bits] = mode;
      }
    }
  }

  /** Seeds of the patterns, by their number in a block. */
  private static final byte[][] PATTERNS_2 =
      SubsetPattern.of(
          2, 28, 20, 16, 29, 91, 9, 107, 72, 149, 204, 50, 114, 496, 17, 78, 39, 252, 828, 43, 156,
          116, 210, 476, 273, 684, 359, 246, 195, 694, 524);

  private static final byte[][] PATTERNS_3 =
      SubsetPattern.of(3, 260, 74, 32, 156, 183, 15, 745, 0, 335, 902, 254);

  private static final byte[][] MERGED_PATTERNS =
      SubsetPattern.of(
          2, 36, 48, 61, 137, 161, 183, 226, 281, 302, 307, 479, 495, 593, 594, 605, 799, 812, 988,
          993);

  private static final byte[][] ONE_SUBSET = {new byte[16]};

  /** Returns whether the first bits of a block are those of a mode. */
  static boolean isKnown(int bits) {
    return BY_CODE[bits & BY_CODE.length - 1] != null;
  }

  /** Returns the mode of a block whose first bits are known. */
  static UastcMode of(int bits) {
    return BY_CODE[bits & BY_CODE.length - 1];
  }

  /** Returns the patterns of subsets: for each, the subset of each texel. */
  byte[][] patterns() {
    return subsets == 1
        ? ONE_SUBSET
        : this == THREE ? PATTERNS_3 : this == MERGED ? MERGED_PATTERNS : PATTERNS_2;
  }

  /** Returns the number of bits of a pattern's number. */
  int patternBits() {
    return subsets == 1 ? 0 : subsets == 2 ? 5 : 4;
  }

  /** Returns the number of bits of the channel that has a weight of its own; without, alpha has. */
  int channelBits() {
    return planes == 2 && channels > 2 ? 2 : 0;
  }

  /**
   * Divides the texels of a block into subsets by a hash of a seed, as ASTC does (Khronos Data
   * Format Specification 1.3, section 23.21). Stateless.
   */
  private static final class SubsetPattern {
    private static final int SEEDS_PER_COUNT = 1024;
    private static final int TEXELS = TexelBlocks.SIDE * TexelBlocks.SIDE;

    private SubsetPattern() {}

    /**
     * Returns the subset of each texel, row by row, for each of some seeds.
     *
     * @param subsets 2 or 3
     */
    static byte[][] of(int subsets, int... seeds) {
      byte[][] patterns = new byte[seeds.length][TEXELS];
      for (int i = 0; i < seeds.length; i++) {
        int hash = hash(seeds[i] + (subsets - 1) * SEEDS_PER_COUNT);
        for (int texel = 0; texel < TEXELS; texel++) {
          int x = texel % TexelBlocks.SIDE;
          patterns[i][texel] = subset(subsets, seeds[i], hash, x, texel / TexelBlocks.SIDE);
        }
      }
      return patterns;
    }

    private static byte subset(int subsets, int seed, int hash, int x, int y) {
      int third = subsets == 3 ? 6 : 5;
      int other = (seed & 2) != 0 ? 4 : 5;
      int shiftX = (seed & 1) != 0 ? other : third;
      int shiftY = (seed & 1) != 0 ? third : other;
      int[] heights = new int[3];
      for (int i = 0; i < subsets; i++) {
        int slopeX = square(hash >>> 8 * i) >> shiftX;
        int slopeY = square(hash >>> 8 * i + 4) >> shiftY;
        // Blocks of fewer than 31 texels are scaled by 2.
        heights[i] = slopeX * 2 * x + slopeY * 2 * y + (hash >>> 14 - 4 * i) & 0x3f;
      }
      boolean isFirst = heights[0] >= heights[1] && heights[0] >= heights[2];
      return (byte) (isFirst ? 0 : heights[1] >= heights[2] ? 1 : 2);
    }

    private static int square(int bits) {
      return (bits & 0xf) * (bits & 0xf);
    }

    private static int hash(int seed) {
      int bits = seed;
      bits ^= bits >>> 15;
      bits -= bits << 17;
      bits += bits << 7;
      bits += bits << 4;
      bits ^= bits >>> 5;
      bits += bits << 16;
      bits ^= bits >>> 7;
      bits ^= bits >>> 3;
      bits ^= bits << 6;
      bits ^= bits >>> 17;
      return bits;
    }
  }
}
