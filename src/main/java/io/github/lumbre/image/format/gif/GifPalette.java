package io.github.lumbre.image.format.gif;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * The colors of all frames, and the choice among them by an ordered dither: neighbors of a pixel
 * get different colors whose mean is the pixel's color. The pattern is fixed on the screen, so that
 * it does not flicker. Colors that the palette has are exact. Mutable.
 *
 * <p>For each color, {@value #LEVELS} palette colors are chosen in turn, each the nearest to the
 * color plus a part of the error so far, and sorted by brightness; the pixel's place in the pattern
 * chooses one of them (T. Knoll, "Pattern dithering", US patent 6606166, expired 2019). The mean is
 * taken of sRGB values, which is good enough for colors as near to each other as here.
 */
final class GifPalette {
  private static final int MOST = 256;

  /** The number of palette colors that are mixed, and of places in the pattern. */
  private static final int LEVELS = 16;

  private static final int SIDE = 4;

  /**
   * The divisor of the error so far. With 1, a small error calls for one pixel of a color far away,
   * which is seen as a speck; with 4, the mean of the pattern is off by at most a quarter of the
   * distance to the nearest color.
   */
  private static final int DAMPING = 4;

  /** The number of colors whose mixture is remembered; a power of two. */
  private static final int SLOTS = 1 << 16;

  private final int[] colors;
  private final boolean isTransparent;
  private final NearestColor nearest;
  private final int[] pattern = pattern();
  private final int[] keys = new int[SLOTS];
  private final byte[] mixtures = new byte[SLOTS * LEVELS];

  private GifPalette(int[] colors, boolean isTransparent) {
    this.colors = colors;
    this.isTransparent = isTransparent;
    nearest = new NearestColor(colors);
    Arrays.fill(keys, -1);
  }

  /** Returns a palette for all colors; exact if they are few enough, and for large areas. */
  static GifPalette of(ColorHistogram histogram) {
    boolean isTransparent = histogram.hasTransparent();
    int most = isTransparent ? MOST - 1 : MOST;
    int[] exact = histogram.someColors();
    int[] colors = exact.length <= most ? exact : mixed(histogram, most);
    int[] sorted = NearestColor.sorted(colors);
    return new GifPalette(sorted.length == 0 ? new int[1] : sorted, isTransparent);
  }

  private static int[] mixed(ColorHistogram histogram, int most) {
    int[] uniform = histogram.uniformColors();
    int[] others = ColorBoxes.colors(histogram, most - uniform.length);
    return IntStream.concat(IntStream.of(uniform), IntStream.of(others)).toArray();
  }

  /** Returns the Bayer matrix of 4 x 4 places (Bayer 1973), row by row. */
  private static int[] pattern() {
    int[] pattern = new int[SIDE * SIDE];
    for (int i = 0; i < pattern.length; i++) {
      int x = i % SIDE;
      int y = i / SIDE;
      for (int bit = 1; bit < SIDE; bit *= 2) {
        int quarter = ((x ^ y) & bit) / bit * 2 + (y & bit) / bit;
        pattern[i] = 4 * pattern[i] + quarter;
      }
    }
    return pattern;
  }

  /** Returns whether a color stands for transparent pixels. */
  boolean isTransparent() {
    return isTransparent;
  }

  /** Returns the index of transparent pixels, which is no color's index. */
  int transparent() {
    return colors.length;
  }

  /** Returns the bits of an index, 1 to 8. */
  int bits() {
    int last = isTransparent ? colors.length : colors.length - 1;
    return Math.max(1, Integer.SIZE - Integer.numberOfLeadingZeros(last));
  }

  /** Returns red, green and blue of 2^{@link #bits} colors; those without a use are black. */
  byte[] bytes() {
    byte[] bytes = new byte[3 << bits()];
    for (int i = 0; i < 3 * colors.length; i++) {
      bytes[i] = (byte) channel(colors[i / 3], i % 3);
    }
    return bytes;
  }

  /**
   * Returns the index of a pixel's color.
   *
   * @param argb 8 bits per channel
   */
  int index(int argb, int x, int y) {
    if (!ColorHistogram.isOpaque(argb)) {
      return transparent();
    }
    int rgb = argb & 0xffffff;
    int slot = (rgb * 0x9e3779b1) >>> 16;
    if (keys[slot] != rgb) {
      keys[slot] = rgb;
      mix(rgb, slot * LEVELS);
    }
    return mixtures[slot * LEVELS + pattern[y % SIDE * SIDE + x % SIDE]] & 0xff;
  }

  /** Stores the mixture of a color from a position on. */
  private void mix(int rgb, int at) {
    int[] errors = new int[3];
    int[] chosen = new int[LEVELS];
    for (int i = 0; i < LEVELS; i++) {
      int wanted = 0;
      for (int channel = 0; channel < 3; channel++) {
        wanted = wanted << 8 | clamp(channel(rgb, channel) + errors[channel] / DAMPING);
      }
      chosen[i] = nearest.index(wanted);
      for (int channel = 0; channel < 3; channel++) {
        errors[channel] += channel(rgb, channel) - channel(colors[chosen[i]], channel);
      }
    }
    Arrays.sort(chosen);
    for (int i = 0; i < LEVELS; i++) {
      mixtures[at + i] = (byte) chosen[i];
    }
  }

  private static int channel(int rgb, int channel) {
    return rgb >> 16 - Byte.SIZE * channel & 0xff;
  }

  private static int clamp(int value) {
    return Math.max(0, Math.min(value, 0xff));
  }
}
