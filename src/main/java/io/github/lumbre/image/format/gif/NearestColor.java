package io.github.lumbre.image.format.gif;

import java.util.Arrays;
import java.util.Comparator;

/**
 * Finds the color of a list that looks most like a given one: the one with the least sum of the
 * squared differences of sRGB values, weighted by 5, 8 and 5, about as the eye weights them (T.
 * Riemersma, "Colour metric", the formula "redmean" at a middle red). Immutable.
 */
final class NearestColor {
  /** The weights of the squared differences of red, green and blue. */
  static final int[] WEIGHTS = {5, 8, 5};

  private final int[] colors;
  private final int[] brightness;

  /**
   * @param colors at least one, in the order of {@link #sorted}
   */
  NearestColor(int[] colors) {
    this.colors = colors;
    brightness = Arrays.stream(colors).map(NearestColor::brightness).toArray();
  }

  /** Returns different colors of 8 bits per channel, sorted by their brightness. */
  static int[] sorted(int[] colors) {
    return Arrays.stream(colors)
        .distinct()
        .boxed()
        .sorted(Comparator.<Integer>comparingInt(c -> brightness(c)).thenComparingInt(c -> c))
        .mapToInt(c -> c)
        .toArray();
  }

  /** Returns about the luma of an sRGB color (ITU-R BT.709), times 10. */
  private static int brightness(int rgb) {
    return 2 * (rgb >> 16) + 7 * (rgb >> 8 & 0xff) + (rgb & 0xff);
  }

  /** Returns the index of the nearest color; always the same one of several. */
  int index(int rgb) {
    int bright = brightness(rgb);
    int found = Arrays.binarySearch(brightness, bright);
    int start = Math.min(found < 0 ? -1 - found : found, colors.length - 1);
    int best = start;
    int least = distance(start, rgb);
    for (int i = start + 1; i < colors.length && isNear(brightness[i] - bright, least); i++) {
      int distance = distance(i, rgb);
      best = distance < least ? i : best;
      least = Math.min(least, distance);
    }
    for (int i = start - 1; i >= 0 && isNear(bright - brightness[i], least); i--) {
      int distance = distance(i, rgb);
      best = distance < least ? i : best;
      least = Math.min(least, distance);
    }
    return best;
  }

  /**
   * Returns whether a color with a difference of brightness can be nearer than a distance: by the
   * Cauchy-Schwarz inequality, its distance is at least the squared difference divided by 2² / 5 +
   * 7² / 8 + 1² / 5 = 57 / 8.
   */
  private static boolean isNear(int difference, int distance) {
    return 8 * difference * difference < 57 * distance;
  }

  private int distance(int index, int rgb) {
    int red = (colors[index] >> 16) - (rgb >> 16);
    int green = (colors[index] >> 8 & 0xff) - (rgb >> 8 & 0xff);
    int blue = (colors[index] & 0xff) - (rgb & 0xff);
    return WEIGHTS[0] * red * red + WEIGHTS[1] * green * green + WEIGHTS[2] * blue * blue;
  }
}
