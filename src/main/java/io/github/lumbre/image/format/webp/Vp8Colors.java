package io.github.lumbre.image.format.webp;

import io.github.lumbre.base.limit.internal.Interrupts;

/**
 * Converts luma and chroma to RGB as libwebp does by default: chroma is interpolated with the
 * weights 9, 3, 3 and 1, and converted by ITU-R BT.601 with fixed-point numbers.
 */
final class Vp8Colors {
  private final Vp8Plane luma;
  private final Vp8Plane[] chroma;
  private final int width;
  private final int height;

  Vp8Colors(Vp8Plane[] planes, int width, int height) {
    luma = planes[0];
    chroma = new Vp8Plane[] {planes[1], planes[2]};
    this.width = width;
    this.height = height;
  }

  /**
   * Returns the colors, pixel by pixel.
   *
   * @param channels 3 or 4, with a place for alpha that stays 0
   */
  byte[] rgb(int channels) {
    byte[] rgb = new byte[channels * width * height];
    int[] us = new int[width];
    int[] vs = new int[width];
    int i = 0;
    for (int y = 0; y < height; y++) {
      Interrupts.check();
      interpolate(chroma[0], y, us);
      interpolate(chroma[1], y, vs);
      int at = luma.at(0, y);
      for (int x = 0; x < width; x++, i += channels) {
        int brightness = scaled(luma.get(at + x), 19077);
        int u = us[x];
        int v = vs[x];
        rgb[i] = rounded(brightness + scaled(v, 26149) - 14234);
        rgb[i + 1] = rounded(brightness - scaled(u, 6419) - scaled(v, 13320) + 8708);
        rgb[i + 2] = rounded(brightness + scaled(u, 33050) - 17685);
      }
    }
    return rgb;
  }

  /** Interpolates the chroma of a row of pixels from the two nearest rows of chroma. */
  private void interpolate(Vp8Plane plane, int y, int[] row) {
    int last = (height - 1) / 2;
    int near = plane.at(0, y / 2);
    int far = plane.at(0, Math.max(0, Math.min(last, y % 2 == 0 ? y / 2 - 1 : y / 2 + 1)));
    row[0] = 3 * plane.get(near) + plane.get(far) + 2 >> 2;
    for (int x = 1; x < width; x += 2) {
      int i = x / 2;
      int nearLeft = plane.get(near + i);
      int farLeft = plane.get(far + i);
      if (x == width - 1) {
        row[x] = 3 * nearLeft + farLeft + 2 >> 2;
        return;
      }
      int nearRight = plane.get(near + i + 1);
      int farRight = plane.get(far + i + 1);
      int sum = nearLeft + nearRight + farLeft + farRight + 8;
      row[x] = (sum + 2 * (nearRight + farLeft) >> 3) + nearLeft >> 1;
      row[x + 1] = (sum + 2 * (nearLeft + farRight) >> 3) + nearRight >> 1;
    }
  }

  private static int scaled(int sample, int factor) {
    return sample * factor >> 8;
  }

  private static byte rounded(int value) {
    return (byte) Vp8Plane.clamped(value >> 6);
  }
}
