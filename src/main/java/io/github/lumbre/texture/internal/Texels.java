package io.github.lumbre.texture.internal;

import java.util.concurrent.atomic.AtomicReferenceArray;

/**
 * One number for each texel of a computed texture. Small textures cache the numbers: a tile is
 * computed on the first access to one of its texels. Large textures compute each number again, to
 * save memory. The values are the same. Thread-safe; two threads may compute the same tile.
 */
final class Texels {
  /** The maximum number of texels of a cached texture, which takes 32 MiB. */
  static final int MAX_KEPT = 1 << 22;

  private static final int LOG_SIDE = 5;
  private static final int SIDE = 1 << LOG_SIDE;
  private static final int MASK = SIDE - 1;

  /** Computes the number of one texel. */
  @FunctionalInterface
  interface Formula {
    /**
     * Returns the number of a texel.
     *
     * @param column counted from the left
     * @param row counted from the top
     */
    double at(int column, int row);
  }

  private final int width;
  private final int height;
  private final Formula formula;
  private final boolean kept;
  private final int tilesPerRow;
  private final AtomicReferenceArray<double[]> tiles;

  /**
   * Creates the numbers of a texture.
   *
   * @param formula a pure function
   */
  Texels(int width, int height, Formula formula) {
    requireSize(width, height);
    this.width = width;
    this.height = height;
    this.formula = formula;
    kept = (long) width * height <= MAX_KEPT;
    tilesPerRow = tilesOver(width);
    tiles = new AtomicReferenceArray<>(kept ? tilesPerRow * tilesOver(height) : 0);
  }

  /**
   * Checks the size of a texture.
   *
   * @throws IllegalArgumentException if the width or height is out of range
   */
  static void requireSize(int width, int height) {
    int max = TexelTexture.MAX_SIDE;
    if (width < 1 || width > max || height < 1 || height > max) {
      throw new IllegalArgumentException(
          "width and height: expected 1 to " + max + ", found " + width + "x" + height);
    }
  }

  private static int tilesOver(int size) {
    return (size + MASK) >> LOG_SIDE;
  }

  int width() {
    return width;
  }

  int height() {
    return height;
  }

  /** Returns the number of a texel; row 0 is at the top. */
  double at(int column, int row) {
    if (!kept) {
      return formula.at(column, row);
    }
    int index = (row >> LOG_SIDE) * tilesPerRow + (column >> LOG_SIDE);
    double[] tile = tiles.getAcquire(index);
    if (tile == null) {
      tile = tile(column & ~MASK, row & ~MASK);
      tiles.setRelease(index, tile);
    }
    return tile[(row & MASK) << LOG_SIDE | column & MASK];
  }

  private double[] tile(int left, int top) {
    double[] tile = new double[SIDE * SIDE];
    for (int y = 0; y < Math.min(SIDE, height - top); y++) {
      for (int x = 0; x < Math.min(SIDE, width - left); x++) {
        tile[y << LOG_SIDE | x] = formula.at(left + x, top + y);
      }
    }
    return tile;
  }
}
