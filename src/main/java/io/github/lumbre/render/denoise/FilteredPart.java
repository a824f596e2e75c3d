package io.github.lumbre.render.denoise;

/**
 * The pixels of a tile's level that are filtered: whole {@link FilteredUnits units}.
 *
 * @param left the tile's first column, counted as {@link Features} does
 * @param top its first row
 * @param width of the level
 * @param level 0 is full size
 */
record FilteredPart(FilteredUnits units, int left, int top, int width, int level) {
  /** Receives the columns of a row that are filtered, from one to another. */
  interface Columns {
    void accept(int x, int end);
  }

  private int unit() {
    return TileFilter.UNIT >> level;
  }

  /** Returns whether a pixel is filtered. */
  boolean contains(int x, int y) {
    return units.contains(left + (x << level), top + (y << level));
  }

  /** Returns the column up to which all pixels from x on are filtered or none is. */
  int end(int x, int y) {
    boolean isFiltered = contains(x, y);
    int end = x;
    do {
      end += unit() - end % unit();
    } while (end < width && contains(end, y) == isFiltered);
    return end;
  }

  /** Calls back for each run of filtered pixels of a row. */
  void forEach(int y, Columns columns) {
    for (int x = 0, end; x < width; x = end) {
      end = end(x, y);
      if (contains(x, y)) {
        columns.accept(x, end);
      }
    }
  }

  /** Returns the row, at most a last one, up to which the rows from y on have the same columns. */
  int bottom(int y, int last) {
    int bottom = y;
    do {
      bottom += unit() - bottom % unit();
    } while (bottom < last && hasColumnsOf(y, bottom));
    return Math.min(last, bottom);
  }

  private boolean hasColumnsOf(int y, int other) {
    for (int x = 0; x < width; x += unit()) {
      if (contains(x, y) != contains(x, other)) {
        return false;
      }
    }
    return true;
  }
}
