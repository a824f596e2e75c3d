package io.github.lumbre.image.compare.internal;

import io.github.lumbre.image.internal.Srgb;

/** Maps numbers to colors. Stateless. */
public final class HeatScale {
  private HeatScale() {}

  /**
   * Writes a color in linear light, interpolated between sRGB-encoded colors.
   *
   * @param place on the scale, clamped to [0,1]
   * @param colors at least two, evenly spaced, each with three values from 0 to 255
   * @param at index of the red value in {@code rgb}
   */
  public static void paint(double place, int[][] colors, float[] rgb, int at) {
    double scaled = Math.max(0, Math.min(place, 1)) * (colors.length - 1);
    int below = Math.min((int) scaled, colors.length - 2);
    for (int c = 0; c < 3; c++) {
      double encoded =
          colors[below][c] + (scaled - below) * (colors[below + 1][c] - colors[below][c]);
      rgb[at + c] = (float) Srgb.decode(encoded / 255);
    }
  }
}
