package io.github.lumbre.image.ktx;

/**
 * Divides the texels of a block into subsets by a hash of a seed, as ASTC does (Khronos Data Format
 * Specification 1.3, section 23.21). Stateless.
 */
final class SubsetPattern {
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
