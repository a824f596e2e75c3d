package io.github.lumbre.render;

import io.github.lumbre.scene.RenderSettings;
import java.util.Optional;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;

/**
 * Gives more samples to pixels whose neighbours are noisier: after a pilot of as many for all, each
 * pass doubles the samples of those pixels where the same work takes most off the relative squared
 * error of the picture.
 *
 * <p>A doubling takes about half of a pixel's error away, so it is worth e/n a sample, and e/(n c)
 * a ray, for a pixel with n samples, the error e and samples of c rays. What is known of e hangs on
 * few numbers, so it is told from a square of pixels around, as the squared mean of the roots of
 * their variances, in which single bright spots count for less than in the mean of variances; and c
 * is the mean of theirs. The pixel's own samples are left out. If they had a say, pixels whose
 * bright samples came late would stay with those they have, and the picture would be too dark; as
 * it is, they reach the number of the pixel's samples only through the numbers of its neighbours',
 * and those change the spread of what is told of them, not its mean (but for the rest that
 * docs/trade.md measures).
 *
 * <p>Numbers of samples are powers of two, where Sobol points are evenest and the halves of {@link
 * Film#halves} as large. No pixel has less than an eighth of the mean, lest neighbourhoods that saw
 * nothing yet are never looked at again.
 */
final class AdaptiveSchedule implements Schedule {
  /** Samples per pixel of the pilot. */
  static final int PILOT = 32;

  /** No pixel that could be doubled has less than the mean over this. */
  private static final int MOST_BELOW_MEAN = 8;

  /** A pass adds as many samples as there are, over this. */
  private static final int PASSES_TO_DOUBLE = 4;

  /** Pixels to each side that tell a pixel's noise. */
  private static final int REACH = 2;

  /** Priorities are told apart by the upper half of their floats: to 1 %. */
  private static final int BINS = 1 << 15;

  private static final int FIRST_BIN_BIT = 16;

  /** What a sample takes beside its rays, in rays. */
  private static final float RAYS_TO_BEGIN = 1;

  private final int goal;

  /** Rays that the samples of each pixel took; empty before the first pass. */
  private long[] rays = {};

  /** What each pixel is to have; empty before the pilot has ended. */
  private int[] targets = {};

  /**
   * @param goal samples per pixel in the mean; what is left below the cost of a doubling is not
   *     spent
   */
  AdaptiveSchedule(int goal) {
    this.goal = goal;
  }

  @Override
  public Optional<SampleTarget> next(Film film) {
    if (rays.length == 0) {
      rays = new long[film.window().width() * film.window().height()];
    }
    int fewest = film.fewestSamples();
    int pilot = Math.min(PILOT, goal);
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

  /** Chooses the pixels to be doubled; tells whether there are any. */
  private boolean choose(Film film) {
    int pixels = film.window().width() * film.window().height();
    long total = film.totalSamples();
    long left = Math.min((long) goal * pixels - total, total / PASSES_TO_DOUBLE);
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
    return left < before || doubleCheapest((long) goal * pixels - total);
  }

  private int doubled(int pixel) {
    int more = targets[pixel];
    if (more > RenderSettings.MAX_SAMPLES / 2) {
      return 0;
    }
    targets[pixel] += more;
    return more;
  }

  /** Goes on where a pass is too short for any pixel, in pictures of few. */
  private boolean doubleCheapest(long left) {
    int cheapest =
        IntStream.range(0, targets.length)
            .reduce((a, b) -> targets[b] < targets[a] ? b : a)
            .getAsInt();
    return targets[cheapest] <= left && doubled(cheapest) != 0;
  }

  /** Returns the highest bin of which not all pixels can be doubled. */
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
   * Returns how much each pixel's doubling is worth for its work, in bins of a logarithmic scale.
   *
   * @param least samples that each pixel is to have before all else
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

  /** Returns of each pixel the root of the variance of a single sample. */
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

  /** Returns of each pixel how many rays a sample takes. */
  private float[] costs(Film film) {
    float[] costs = new float[rays.length];
    for (int i = 0; i < costs.length; i++) {
      costs[i] = (float) rays[i] / film.samples(i);
    }
    return costs;
  }

  /** Returns the mean over the pixels around one, itself left out; 0 if there are none. */
  private static float around(float[] values, int x, int y, int width, int height) {
    int fromX = Math.max(0, x - REACH);
    int toX = Math.min(width - 1, x + REACH);
    int fromY = Math.max(0, y - REACH);
    int toY = Math.min(height - 1, y + REACH);
    // In double precision, so that nothing of the pixel's own stays when it is taken away.
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
