package io.github.lumbre.render;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;

/**
 * Sums of samples, exact: each value is rounded once to a multiple of 2^-64 and added in 128 bits,
 * so that the same samples give the same bits in whatever order and grouping they arrive. Mutable;
 * different threads may write different pixels.
 *
 * <p>Takes 52 bytes a pixel, 56 with alpha.
 */
final class Film {
  /** What one sample value is cut to: 2^30 of them still fit. */
  static final double LARGEST = 0x1p32;

  private final int width;
  private final int height;

  /** Whole parts and fractions (in units of 2^-64, unsigned) of the sums, three a pixel. */
  private final long[] whole;

  private final long[] fraction;
  private final int[] counts;

  /** How many of a pixel's samples cover it; empty if all do. */
  private final int[] covered;

  Film(int width, int height, boolean hasAlpha) {
    this.width = width;
    this.height = height;
    int pixels = Math.multiplyExact(width, height);
    whole = new long[Math.multiplyExact(3, pixels)];
    fraction = new long[3 * pixels];
    counts = new int[pixels];
    covered = new int[hasAlpha ? pixels : 0];
  }

  /**
   * Adds a sample; values above {@link #LARGEST} count as that.
   *
   * @param value finite and ≥ 0
   * @param covers whether the sample belongs to the picture, for its alpha
   */
  void add(int pixel, Rgb value, boolean covers) {
    add(3 * pixel, value.r());
    add(3 * pixel + 1, value.g());
    add(3 * pixel + 2, value.b());
    counts[pixel]++;
    if (covers && covered.length != 0) {
      covered[pixel]++;
    }
  }

  private void add(int i, double value) {
    assert value >= 0 && value < Double.POSITIVE_INFINITY : value;
    double cut = Math.min(value, LARGEST);
    long units = (long) cut;
    // The rest times 2^64; only a rest below 2^-12 needs rounding, so it cannot become 2^64.
    double rest = Math.rint((cut - units) * 0x1p64);
    long bits = rest < 0x1p63 ? (long) rest : (long) (rest - 0x1p63) | Long.MIN_VALUE;
    long sum = fraction[i] + bits;
    whole[i] += units + (Long.compareUnsigned(sum, bits) < 0 ? 1 : 0);
    fraction[i] = sum;
  }

  /** Returns the means of the samples; pixels without samples are black and transparent. */
  Image develop() {
    float[] rgb = new float[whole.length];
    float[] alpha = new float[covered.length];
    for (int pixel = 0; pixel < counts.length; pixel++) {
      // Straight alpha: the colour is the mean over the covering samples alone.
      int count = covered.length == 0 ? counts[pixel] : covered[pixel];
      for (int i = 3 * pixel; i < 3 * pixel + 3; i++) {
        rgb[i] = count == 0 ? 0 : (float) (sum(i) / count);
      }
      if (covered.length != 0 && count != 0) {
        alpha[pixel] = (float) count / counts[pixel];
      }
    }
    return new Image(width, height, rgb, alpha);
  }

  private double sum(int i) {
    double low = (fraction[i] >>> 1) * 0x1p-63 + (fraction[i] & 1) * 0x1p-64;
    return whole[i] + low;
  }
}
