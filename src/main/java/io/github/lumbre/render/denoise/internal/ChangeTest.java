package io.github.lumbre.render.denoise.internal;

import io.github.lumbre.math.internal.Elementary;
import java.util.function.IntToDoubleFunction;

/**
 * Tests whether light has changed between frames by more than the noise that is left. Differences
 * are divided by the standard deviation that noise gives to them. Two values are about 1 or less if
 * there is nothing but noise: the mean of their squares close to a pixel, which finds changes of
 * small things; and the square of their mean in a larger neighborhood, scaled, which finds small
 * changes that have one sign, as those of shadows and lamps. Immutable.
 */
final class ChangeTest {
  /** What {@link #weights} needs in memory. */
  static final int BYTES_PER_PIXEL = 5 * 4;

  /** Pixels to each side whose squares are averaged. */
  private static final int NEAR = 2;

  /** Pixels to each side whose differences are averaged. */
  private static final int WIDE = 8;

  /** How much smaller noise makes the square of that mean: errors of near pixels are alike. */
  private static final float INDEPENDENT = 8;

  /** Values up to this are those of noise. */
  private static final float EXPECTED = 1;

  /** The excess that makes weights smaller by a factor of e. */
  private static final float TOLERANCE = .5f;

  /** Differences of more standard deviations count as this. */
  private static final double LARGEST = 1e3;

  private final int width;
  private final int height;
  private final IntToDoubleFunction leastVariance;
  private final int threads;

  /**
   * @param leastVariance is added to the variance of each pixel; above 0 where light is
   */
  ChangeTest(int width, int height, IntToDoubleFunction leastVariance, int threads) {
    this.width = width;
    this.height = height;
    this.leastVariance = leastVariance;
    this.threads = threads;
  }

  /**
   * Returns weights in [0,1] for the pixels of a frame: 1 where light is the same.
   *
   * @param differences of light, three values for each pixel
   * @param variances that noise gives to them, summed over the channels
   * @param counts 1 for each pixel that has a difference, otherwise 0, as its weight is
   */
  float[] weights(float[] differences, float[] variances, float[] counts)
      throws InterruptedException {
    float[][] deviations = new float[3][counts.length];
    float[] squares = new float[counts.length];
    Rows.forEach(
        width,
        height,
        threads,
        i -> {
          double deviation = Math.sqrt(variances[i] + leastVariance.applyAsDouble(i));
          for (int c = 0; c < 3 && counts[i] > 0; c++) {
            float value = inDeviations(differences[3 * i + c], deviation);
            deviations[c][i] = value;
            squares[i] += value * value;
          }
        });
    float[] weights = new float[counts.length];
    Rows.compute(
        height,
        threads,
        () -> {
          RowTest test = new RowTest();
          return y -> test.weigh(y, deviations, squares, counts, weights);
        });
    return weights;
  }

  private static float inDeviations(double difference, double deviation) {
    return difference == 0
        ? 0
        : (float) Math.max(-LARGEST, Math.min(LARGEST, difference / deviation));
  }

  /** Weighs the pixels of rows. Mutable; each thread has one. */
  private final class RowTest {
    private final Sums near = new Sums(width, height, NEAR);
    private final Sums wide = new Sums(width, height, WIDE);
    private final float[] numbers = new float[width];
    private final float[] sums = new float[width];
    private final float[] squared = new float[width];
    private final float[] common = new float[width];

    void weigh(int y, float[][] deviations, float[] squares, float[] counts, float[] weights) {
      near.of(counts, y, numbers);
      near.of(squares, y, squared);
      for (int x = 0; x < width; x++) {
        squared[x] /= Math.max(1, numbers[x]);
        common[x] = 0;
      }
      wide.of(counts, y, numbers);
      for (float[] channel : deviations) {
        wide.of(channel, y, sums);
        for (int x = 0; x < width; x++) {
          float mean = sums[x] / Math.max(1, numbers[x]);
          common[x] += INDEPENDENT * mean * mean;
        }
      }
      for (int x = 0; x < width; x++) {
        float excess = Math.max(0, squared[x] - EXPECTED) + Math.max(0, common[x] - EXPECTED);
        int pixel = y * width + x;
        boolean isSame = excess == 0 || counts[pixel] == 0;
        weights[pixel] =
            isSame ? counts[pixel] : (float) Elementary.exp(-excess / (double) TOLERANCE);
      }
    }
  }
}
