package io.github.lumbre.image.format.webp;

import io.github.lumbre.base.limit.internal.Interrupts;

/**
 * Smooths the edges of blocks (RFC 6386, sec. 15).
 *
 * @param isSimple whether only luma is smoothed, with two samples at each edge
 * @param sharpness from 0 to 7
 * @param levels the strengths for each segment, 0 to 63: of a macroblock with one mode, and of a
 *     split one
 */
record Vp8Filters(boolean isSimple, int sharpness, int[] levels) {
  private static final int INNER = 1 << 6;
  private static final int MACROBLOCK = 16;

  /**
   * Returns the code of a macroblock for {@link #apply}.
   *
   * @param hasInner whether the edges within the macroblock are smoothed
   */
  byte code(int segment, boolean isSplit, boolean hasInner) {
    return (byte) (levels[2 * segment + (isSplit ? 1 : 0)] | (hasInner ? INNER : 0));
  }

  /**
   * Smooths all macroblocks.
   *
   * @param codes of the macroblocks, row by row
   * @param planes luma and the two chromas
   */
  void apply(byte[] codes, int columns, Vp8Plane[] planes) {
    for (int i = 0; i < codes.length; i++) {
      if (i % columns == 0) {
        Interrupts.check();
      }
      int level = codes[i] & INNER - 1;
      if (level > 0) {
        smooth(planes, i % columns, i / columns, level, (codes[i] & INNER) != 0);
      }
    }
  }

  private void smooth(Vp8Plane[] planes, int column, int row, int level, boolean hasInner) {
    int interior = level;
    if (sharpness > 0) {
      interior = Math.min(level >> (sharpness > 4 ? 2 : 1), 9 - sharpness);
    }
    interior = Math.max(1, interior);
    int limit = 2 * (2 * level + interior) + 1;
    int variance = level < 15 ? 0 : level < 40 ? 1 : 2;
    Vp8Edge outer = new Vp8Edge(limit + 8, interior, variance, true);
    Vp8Edge inner = new Vp8Edge(limit, interior, variance, false);
    for (int p = 0; p < (isSimple ? 1 : planes.length); p++) {
      Vp8Plane plane = planes[p];
      int side = p == 0 ? MACROBLOCK : MACROBLOCK / 2;
      int at = plane.at(column * side, row * side);
      for (int i = column > 0 ? 0 : 4; i < (hasInner ? side : 4); i += 4) {
        smoothEdge(plane, at + i, plane.stride(), 1, side, i == 0 ? outer : inner);
      }
      for (int i = row > 0 ? 0 : 4; i < (hasInner ? side : 4); i += 4) {
        int start = at + i * plane.stride();
        smoothEdge(plane, start, 1, plane.stride(), side, i == 0 ? outer : inner);
      }
    }
  }

  /**
   * Smooths an edge.
   *
   * @param at the position of the first sample after the edge
   * @param along the distance of two samples along the edge
   * @param across the distance of two samples across it
   */
  private void smoothEdge(Vp8Plane plane, int at, int along, int across, int count, Vp8Edge edge) {
    for (int i = 0; i < count; i++) {
      if (isSimple) {
        edge.smoothSimply(plane, at + i * along, across);
      } else {
        edge.smooth(plane, at + i * along, across);
      }
    }
  }
}
