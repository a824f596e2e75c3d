package io.github.lumbre.render;

import io.github.lumbre.render.internal.Passes;
import io.github.lumbre.scene.RenderSettings;
import java.util.Optional;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;

/**
 * Gives more samples to pixels with noisier neighbors. After a pilot with equally many samples in
 * all pixels, each pass doubles the samples of selected pixels. It selects the pixels where the
 * doubling reduces the picture's relative squared error most for its work.
 *
 * <p>A doubling removes about half of a pixel's error. For a pixel with n samples, the error e and
 * c rays per sample, this is worth e/n per sample and e/(n c) per ray. A pixel has few samples for
 * an estimate of e, so e comes from the square of pixels around it: the squared mean of their
 * standard deviations. Single bright spots weigh less in it than in the mean of the variances. The
 * cost c is the mean over the same pixels.
 *
 * <p>The pixel's own samples are left out. If they were used, pixels whose bright samples come late
 * would keep too few samples, and the picture would be too dark. Without them, a pixel's samples
 * affect its sample count only through the sample counts of its neighbors. Those counts change the
 * variance of the neighbors' noise estimates and not their mean, except for the small rest that
 * docs/trade.md measures.
 *
 * <p>Sample counts are powers of two, at which Sobol points are most even and the halves of {@link
 * Film#halves} have equal size. Every pixel has at least an eighth of the mean sample count, so
 * that neighborhoods without any light so far are sampled again.
 */
final class AdaptiveSchedule implements Schedule {
  /** Samples per pixel of the pilot. */
  static final int PILOT = 32;

  /** Every pixel that can be doubled has at least the mean sample count divided by this. */
  private static final int MOST_BELOW_MEAN = 8;

  /** A pass adds at most the current number of samples divided by this. */
  private static final int PASSES_TO_DOUBLE = 4;

  /** The radius, in pixels, of the square that estimates a pixel's noise. */
  private static final int REACH = 2;

  /** The number of priorities: the upper half of a float, with a relative precision of 1 %. */
  private static final int BINS = 1 << 15;

  private static final int FIRST_BIN_BIT = 16;

  /** The fixed cost of a sample, in rays. */
  private static final float RAYS_TO_BEGIN = 1;

  private final int goal;
  private final int pilot;

  /** The number of rays of each pixel's samples; empty before the first pass. */
  private long[] rays = {};

  /** The target sample count of each pixel; empty until the pilot has ended. */
  private int[] targets = {};

  /**
   * Creates the schedule of one film.
   *
   * @param goal mean samples per pixel; a rest that is too small for a doubling is not used
   * @param poses number of poses; the noise of a pixel is known from two samples of each pose on
   */
  AdaptiveSchedule(int goal, int poses) {
    this.goal = goal;
    pilot = Math.min(Math.max(PILOT, 2 * poses), goal);
  }

  @Override
  public Optional<SampleTarget> next(Film film) {
    if (rays.length == 0) {
      rays = new long[(int) film.window().pixels()];
    }
    int fewest = film.fewestSamples();
    if (fewest < pilot) {
      int end = Passes.next(fewest, pilot);
      return Optional.of(target(film, pixel -> end));
    }
    if (isMet(film) && !choose(film)) {
      return Optional.empty();
    }
    int[] wanted = targets;
    return Optional.of(target(film, pixel -> wanted[pixel]));
  }

  private SampleTarget target(Film film, IntUnaryOperator wanted) {
    return new SampleTarget() {
      @Override
      public int samples(int x, int y) {
        return wanted.applyAsInt(film.index(x, y));
      }

      @Override
      public void took(int x, int y, long more) {
        rays[film.index(x, y)] += more;
      }
    };
  }

  private boolean isMet(Film film) {
    return IntStream.range(0, targets.length).allMatch(i -> film.samples(i) >= targets[i]);
  }

  /** Selects the pixels to double; returns whether there are any. */
  private boolean choose(Film film) {
    int pixels = (int) film.window().pixels();
    long total = film.totalSamples();
    long rest = (long) goal * pixels - total;
    if (rest <= 0) {
      return false;
    }
    long left = Math.min(rest, total / PASSES_TO_DOUBLE);
    left = Math.min(left, (long) Passes.LONGEST * pixels);
    targets = IntStream.range(0, pixels).map(film::samples).toArray();
    short[] bins = bins(film, (double) total / pixels / MOST_BELOW_MEAN);
    long before = left;
    int border = border(bins, left);
    for (int i = 0; i < pixels; i++) {
      left -= bins[i] > border ? doubled(i) : 0;
    }
    for (int i = 0; i < pixels; i++) {
      left -= bins[i] == border && targets[i] <= left ? doubled(i) : 0;
    }
    return left < before || doubleCheapest(rest);
  }

  private int doubled(int pixel) {
    int more = targets[pixel];
    if (more > RenderSettings.MAX_SAMPLES / 2) {
      return 0;
    }
    targets[pixel] += more;
    return more;
  }

  /**
   * Doubles the pixel with the fewest samples, for small pictures whose pass is too short for any
   * pixel.
   */
  private boolean doubleCheapest(long left) {
    int cheapest =
        IntStream.range(0, targets.length)
            .reduce((a, b) -> targets[b] < targets[a] ? b : a)
            .getAsInt();
    return targets[cheapest] <= left && doubled(cheapest) != 0;
  }

  /** Returns the highest bin whose pixels cannot all be doubled. */
  private int border(short[] bins, long samples) {
    long[] costs = new long[BINS];
    for (int i = 0; i < bins.length; i++) {
      costs[bins[i]] += targets[i];
    }
    long left = samples;
    int bin = BINS - 1;
    while (bin > 0 && costs[bin] <= left) {
      left -= costs[bin];
      bin--;
    }
    return bin;
  }

  /**
   * Returns the priority of each pixel's doubling, its worth per work, in bins of a logarithmic
   * scale.
   *
   * @param least pixels with fewer samples have the highest priority
   */
  private short[] bins(Film film, double least) {
    int width = film.window().width();
    int height = film.window().height();
    float[] deviations = deviations(film);
    float[] costs = costs(film);
    short[] bins = new short[width * height];
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        int i = y * width + x;
        float deviation = around(deviations, x, y, width, height);
        float root = deviation / film.samples(i);
        float cost = around(costs, x, y, width, height) + RAYS_TO_BEGIN;
        float worth = film.samples(i) < least ? Float.POSITIVE_INFINITY : root * root / cost;
        bins[i] = (short) (Float.floatToIntBits(worth) >>> FIRST_BIN_BIT);
      }
    }
    return bins;
  }

  /** Returns, for each pixel, the standard deviation of a single sample. */
  private static float[] deviations(Film film) {
    int left = film.window().x();
    int top = film.window().y();
    int width = film.window().width();
    float[] deviations = new float[width * film.window().height()];
    for (int i = 0; i < deviations.length; i++) {
      PixelHalves halves = film.halves(left + i % width, top + i / width).orElseThrow();
      deviations[i] = (float) Math.sqrt(halves.relativeSquaredError() * film.samples(i));
    }
    return deviations;
  }

  /** Returns, for each pixel, the mean number of rays per sample. */
  private float[] costs(Film film) {
    float[] costs = new float[rays.length];
    for (int i = 0; i < costs.length; i++) {
      costs[i] = (float) rays[i] / film.samples(i);
    }
    return costs;
  }

  /**
   * Returns the mean over the pixels around a pixel, without the pixel itself; 0 if there are none.
   */
  private static float around(float[] values, int x, int y, int width, int height) {
    int fromX = Math.max(0, x - REACH);
    int toX = Math.min(width - 1, x + REACH);
    int fromY = Math.max(0, y - REACH);
    int toY = Math.min(height - 1, y + REACH);
    // In double precision, so that subtracting the pixel's own value leaves no remainder.
    double sum = -values[y * width + x];
    for (int row = fromY; row <= toY; row++) {
      for (int i = row * width + fromX; i <= row * width + toX; i++) {
        sum += values[i];
      }
    }
    int others = (toX - fromX + 1) * (toY - fromY + 1) - 1;
    return others == 0 ? 0 : (float) (Math.max(0, sum) / others);
  }
}
