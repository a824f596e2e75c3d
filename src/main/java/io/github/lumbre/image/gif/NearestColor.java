package io.github.lumbre.image.gif;

/** Finds the color of a list that looks most like a given one. Immutable. */
final class NearestColor {
  private static final int[] WEIGHTS = ColorClusters.WEIGHTS;

  private final int[] red;
  private final int[] green;
  private final int[] blue;

  /**
   * @param colors at least one, 8 bits per channel
   */
  NearestColor(int[] colors) {
    red = new int[colors.length];
    green = new int[colors.length];
    blue = new int[colors.length];
    for (int i = 0; i < colors.length; i++) {
      red[i] = colors[i] >> 16 & 0xff;
      green[i] = colors[i] >> 8 & 0xff;
      blue[i] = colors[i] & 0xff;
    }
  }

  /** Returns the index of the nearest color; the first one of several. */
  int index(int r, int g, int b) {
    int best = 0;
    int least = Integer.MAX_VALUE;
    for (int i = 0; i < red.length; i++) {
      int dr = red[i] - r;
      int dg = green[i] - g;
      int db = blue[i] - b;
      int distance = WEIGHTS[0] * dr * dr + WEIGHTS[1] * dg * dg + WEIGHTS[2] * db * db;
      if (distance < least) {
        least = distance;
        best = i;
      }
    }
    return best;
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
