package io.github.lumbre.render;

import io.github.lumbre.image.Rgb;
import java.util.Optional;

/**
 * The mean of each pixel's first samples, up to the largest power of two below their number, from
 * which the halves of a pixel follow. Packed, and so rounded. Mutable; different threads may write
 * different pixels.
 */
final class FirstMeans {
  private final ExactSums sums;
  private final int[] counts;
  private final long[] means;

  /** How the mean of a pixel's first samples changes when a film is added. */
  enum FirstMean {
    /** It stays the mean of the same samples. */
    KEPT,
    /** It is unknown. */
    LOST,
    /** It becomes the mean of the other film. */
    OF_OTHER,
    /** It becomes the mean of all samples before the other film is added. */
    OF_ALL
  }

  /**
   * @param sums three sums for each pixel
   * @param counts the number of samples of each pixel
   */
  FirstMeans(ExactSums sums, int[] counts) {
    this.sums = sums;
    this.counts = counts;
    means = new long[counts.length];
  }

  /** Returns the packed mean of a pixel; {@link PackedRgb#NONE} if there is none. */
  long packed(int pixel) {
    return means[pixel];
  }

  void set(int pixel, long packed) {
    means[pixel] = packed;
  }

  void set(FirstMeans other) {
    System.arraycopy(other.means, 0, means, 0, means.length);
  }

  /** Stores the mean of all samples of a pixel so far; there must be at least one. */
  void store(int pixel) {
    int count = counts[pixel];
    means[pixel] =
        PackedRgb.of(
            sums.get(3 * pixel) / count,
            sums.get(3 * pixel + 1) / count,
            sums.get(3 * pixel + 2) / count);
  }

  /**
   * Updates the mean of a pixel before the samples of another film are added to the sums. It is
   * lost if the sums do not contain it.
   *
   * @param from the pixel in the other film, with at least one sample
   * @param to the pixel in this film
   * @param continues whether the other film's samples follow the samples of this film
   */
  FirstMean add(FirstMeans other, int from, int to, boolean continues) {
    FirstMean mean = after(counts[to], other.counts[from], continues);
    switch (mean) {
      case KEPT -> {}
      case LOST -> means[to] = PackedRgb.NONE;
      case OF_OTHER -> means[to] = other.means[from];
      case OF_ALL -> store(to);
    }
    return mean;
  }

  private static FirstMean after(int count, int more, boolean continues) {
    if (count == 0) {
      return FirstMean.OF_OTHER;
    }
    int power = Integer.highestOneBit(count + more - 1);
    if (!continues || power > count) {
      return FirstMean.LOST;
    }
    return power == count ? FirstMean.OF_ALL : FirstMean.KEPT;
  }

  /** Returns the halves of a pixel with at least two samples; empty if its mean was lost. */
  Optional<PixelHalves> halves(int pixel) {
    if (means[pixel] == PackedRgb.NONE) {
      return Optional.empty();
    }
    int count = counts[pixel];
    int firstCount = Integer.highestOneBit(count - 1);
    int secondCount = count - firstCount;
    Rgb first = PackedRgb.unpacked(means[pixel]);
    Rgb all = new Rgb(sums.get(3 * pixel), sums.get(3 * pixel + 1), sums.get(3 * pixel + 2));
    Rgb second = all.plus(first.times(-firstCount)).times(1.0 / secondCount);
    return Optional.of(new PixelHalves(firstCount, first, secondCount, second));
  }
}
