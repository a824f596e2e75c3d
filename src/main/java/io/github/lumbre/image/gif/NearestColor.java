package io.github.lumbre.image.gif;

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

  /** More than any distance. */
  private static final int FAR = 1 << 25;

  private final int[] red;
  private final int[] green;
  private final int[] blue;
  private final int[] brightness;

  /**
   * @param colors at least one, in the order of {@link #sorted}
   */
  NearestColor(int[] colors) {
    red = Arrays.stream(colors).map(color -> color >> 16).toArray();
    green = Arrays.stream(colors).map(color -> color >> 8 & 0xff).toArray();
    blue = Arrays.stream(colors).map(color -> color & 0xff).toArray();
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

  private static int brightness(int rgb) {
    return brightness(rgb >> 16, rgb >> 8 & 0xff, rgb & 0xff);
  }

  /** Returns about the luma of an sRGB color (ITU-R BT.709), times 10. */
  private static int brightness(int r, int g, int b) {
    return 2 * r + 7 * g + b;
  }

  /** Returns the index of the nearest color; always the same one of several. */
  int index(int r, int g, int b) {
    int bright = brightness(r, g, b);
    int found = Arrays.binarySearch(brightness, bright);
    int above = found < 0 ? -1 - found : found;
    int below = above - 1;
    int best = -1;
    int least = FAR;
    while (above < red.length || below >= 0) {
      if (above < red.length) {
        int distance = distance(above, r, g, b);
        if (distance < least) {
          least = distance;
          best = above;
        }
        above = isFarther(brightness[above] - bright, least) ? red.length : above + 1;
      }
      if (below >= 0) {
        int distance = distance(below, r, g, b);
        if (distance < least) {
          least = distance;
          best = below;
        }
        below = isFarther(bright - brightness[below], least) ? -1 : below - 1;
      }
    }
    return best;
  }

  /**
   * Returns whether all colors with at least a difference of brightness have at least a distance:
   * by the Cauchy-Schwarz inequality, the distance is at least the squared difference divided by 2²
   * / 5 + 7² / 8 + 1² / 5 = 57 / 8.
   */
  private static boolean isFarther(int difference, int distance) {
    return 8 * difference * difference >= 57 * distance;
  }

  private int distance(int index, int r, int g, int b) {
    int dr = red[index] - r;
    int dg = green[index] - g;
    int db = blue[index] - b;
    return WEIGHTS[0] * dr * dr + WEIGHTS[1] * dg * dg + WEIGHTS[2] * db * db;
  }

  int red(int index) {
    return red[index];
  }

  int green(int index) {
    return green[index];
  }

  int blue(int index) {
    return blue[index];
  }
}
