package io.github.lumbre.render.denoise;

/**
 * Which squares of {@link TileFilter#UNIT} pixels the network filters: those with pixels that it
 * could change visibly, or near such pixels. The other squares stay as they were rendered, such as
 * the sky behind a model. Immutable after {@link #of}.
 *
 * <p>A pixel could be changed visibly if the bound of the change, {@link BuiltInDenoiser#FARTHEST}
 * standard deviations, is more than a small part of its light. So a square that is not filtered
 * differs invisibly from what the network would have made of it.
 */
final class FilteredUnits {
  /** This part of a pixel's light is less than half a step of eight bits. */
  private static final double INVISIBLE = 1. / 256;

  /** Distance in pixels from a noisy pixel within which squares are filtered. */
  private static final int CONTEXT = 8;

  private final int across;
  private final boolean[] filtered;

  /**
   * @param across number of squares beside each other
   * @param filtered by row and column
   */
  FilteredUnits(int across, boolean[] filtered) {
    this.across = across;
    this.filtered = filtered;
  }

  /** Returns the squares of a picture that are filtered. */
  static FilteredUnits of(Features picture, Workers workers) throws InterruptedException {
    int across = count(picture.right());
    boolean[] none = new boolean[Math.multiplyExact(across, count(picture.bottom()))];
    FilteredUnits units = new FilteredUnits(across, none);
    int right = picture.right() - 1;
    int bottom = picture.bottom() - 1;
    workers.compute(
        picture.height(),
        (first, end, convolution) -> {
          boolean[] noisy = new boolean[picture.width()];
          for (int y = first; y < end; y++) {
            picture.writeNoisy(y, INVISIBLE, noisy);
            int upper = Math.max(0, picture.top() + y - CONTEXT);
            int lower = Math.min(bottom, picture.top() + y + CONTEXT);
            for (int x = 0; x < noisy.length; x++) {
              int from = Math.max(0, picture.left() + x - CONTEXT);
              int to = Math.min(right, picture.left() + x + CONTEXT);
              if (noisy[x]) {
                units.add(from, to, upper, lower);
              }
            }
          }
        });
    return units;
  }

  /** Returns the number of squares that pixels beside each other need. */
  static int count(int pixels) {
    return (pixels + TileFilter.UNIT - 1) / TileFilter.UNIT;
  }

  /** Adds the squares of the corners of a rectangle; threads may add the same ones. */
  private void add(int left, int right, int top, int bottom) {
    int upper = top / TileFilter.UNIT * across;
    int lower = bottom / TileFilter.UNIT * across;
    filtered[upper + left / TileFilter.UNIT] = true;
    filtered[upper + right / TileFilter.UNIT] = true;
    filtered[lower + left / TileFilter.UNIT] = true;
    filtered[lower + right / TileFilter.UNIT] = true;
  }

  /** Returns whether a pixel is filtered. */
  boolean contains(int x, int y) {
    return filtered[y / TileFilter.UNIT * across + x / TileFilter.UNIT];
  }
}
