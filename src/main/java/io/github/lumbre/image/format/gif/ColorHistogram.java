package io.github.lumbre.image.format.gif;

import java.util.BitSet;
import java.util.Comparator;
import java.util.stream.IntStream;

/**
 * Counts the colors of pixels: each color exactly as long as there are few, and all in cells of 4 x
 * 4 x 4 values. Mutable.
 */
final class ColorHistogram {
  static final int CELLS = 1 << 18;

  /** More different colors than a palette can have. */
  private static final int MANY = 257;

  private static final int OPAQUE = 128;

  /** The part of all pixels from which on an area is large is one in so many. */
  private static final int LEAST_SHARE = 100;

  private static final int MOST_UNIFORM = 8;

  private final long[] counts = new long[CELLS];

  /** Sums of the red, green and blue values in each cell. */
  private final long[][] sums = new long[3][CELLS];

  /**
   * A color of each cell: that of more than half of its pixels, if there is one (Boyer and Moore
   * 1991, "MJRTY"), and the lead that it has.
   */
  private final int[] leaders = new int[CELLS];

  private final long[] leads = new long[CELLS];
  private long pixels;

  private final BitSet colors = new BitSet(1 << 24);
  private int different;
  private boolean hasTransparent;

  /** Returns whether a pixel of 8 bits per channel is shown; if not, it is transparent. */
  static boolean isOpaque(int argb) {
    return argb >>> 24 >= OPAQUE;
  }

  /** Counts pixels of 8 bits per channel. */
  void add(int[] argb) {
    for (int pixel : argb) {
      if (!isOpaque(pixel)) {
        hasTransparent = true;
        continue;
      }
      int rgb = pixel & 0xffffff;
      if (different < MANY && !colors.get(rgb)) {
        colors.set(rgb);
        different++;
      }
      int red = rgb >> 16;
      int green = rgb >> 8 & 0xff;
      int blue = rgb & 0xff;
      int cell = red >> 2 << 12 | green >> 2 << 6 | blue >> 2;
      counts[cell]++;
      pixels++;
      if (leads[cell] == 0) {
        leaders[cell] = rgb;
      }
      leads[cell] += leaders[cell] == rgb ? 1 : -1;
      sums[0][cell] += red;
      sums[1][cell] += green;
      sums[2][cell] += blue;
    }
  }

  /** Returns whether any pixel is transparent. */
  boolean hasTransparent() {
    return hasTransparent;
  }

  /** Returns the colors, if there are at most 256; otherwise 257 of them. */
  int[] someColors() {
    return colors.stream().toArray();
  }

  /**
   * Returns colors of large uniform areas, such as the background of a model: the leading colors of
   * the fullest cells, each of at least a hundredth of the pixels.
   */
  int[] uniformColors() {
    return IntStream.range(0, CELLS)
        .filter(cell -> counts[cell] * LEAST_SHARE >= pixels && leads[cell] > 0)
        .boxed()
        .sorted(Comparator.comparingLong((Integer cell) -> -counts[cell]))
        .limit(MOST_UNIFORM)
        .mapToInt(cell -> leaders[cell])
        .toArray();
  }

  /** Returns the number of pixels in a cell. */
  long count(int cell) {
    return counts[cell];
  }

  /**
   * Returns the mean of a channel in a cell that is not empty, rounded to the nearest number.
   *
   * @param channel 0 red, 1 green, 2 blue
   */
  int mean(int cell, int channel) {
    return (int) ((sums[channel][cell] + counts[cell] / 2) / counts[cell]);
  }
}
