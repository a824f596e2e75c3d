package io.github.lumbre.lab.trade;

import io.github.lumbre.lab.perf.SampleBudget;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.internal.FrameSize;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/**
 * The time of a study, and the work that fits into it.
 *
 * @param seconds time from the start, including the page
 * @param samples largest number of samples per pixel of a setting, instead of the time
 * @param reference samples per pixel of the reference; by default 64 times the largest number of a
 *     setting
 * @param seeds number of seeds of each setting; by default as many as fit into the time
 * @param size frame size; by default the scene's, scaled down
 * @param isQuick whether the default frame is even smaller
 */
public record TradeBudget(
    double seconds,
    Optional<Integer> samples,
    Optional<Integer> reference,
    Optional<Integer> seeds,
    Optional<FrameSize> size,
    boolean isQuick) {
  /** The largest accepted number of samples per pixel of a setting. */
  public static final int LARGEST = 1 << 20;

  private static final int PAGE_SIDE = 160;
  private static final int QUICK_SIDE = 96;
  private static final int LEAST_SIDE = 48;

  /** If fewer samples per pixel than this fit into the time, a smaller frame is more useful. */
  private static final int WORTHWHILE = 16;

  /** The approximate maximum number of settings. */
  private static final int MANY_SETTINGS = 20;

  /** The planned number of seeds; if time runs out, at least {@link #LEAST_SEEDS}. */
  private static final int PLANNED_SEEDS = 4;

  private static final int LEAST_SEEDS = 3;
  private static final int MOST_SEEDS = 32;

  /** The reference's samples over the largest number of samples of a setting. */
  private static final int REFERENCE_FACTOR = 64;

  /**
   * The share of the time that is planned from the pilot render's rate. The rest is a reserve for
   * other load on the machine; without such load it is used for more seeds.
   */
  private static final double PLANNED = .6;

  /** The share of the time in which all seeds must end; the rest is for the page. */
  private static final double RENDERING = .85;

  /** The number of single-threaded renders that compare exact settings. */
  private static final int EXACT_RENDERS = 50;

  /** The share of the time for comparing exact settings. */
  private static final double EXACT_SHARE = .1;

  private static final int MOST_EXACT_SAMPLES = 16;
  private static final int STEP = 4;

  /**
   * Returns settings with the frame of a study. Without a given size, the scene's frame is scaled
   * down to a side of 160 pixels (96 for a quick study), or less if time is short.
   *
   * @param rate samples per second of all threads
   */
  public RenderSettings framed(RenderSettings settings, double rate) {
    if (size.isPresent()) {
      return size.get().over(settings);
    }
    RenderSettings framed = SampleBudget.shrunk(settings, isQuick ? QUICK_SIDE : PAGE_SIDE);
    while (samples.isEmpty()
        && mostSamples(rate, 0, MANY_SETTINGS, framed) < WORTHWHILE
        && Math.max(framed.width(), framed.height()) > LEAST_SIDE) {
      framed = SampleBudget.shrunk(framed, Math.max(framed.width(), framed.height()) * 3 / 4);
    }
    return framed;
  }

  /**
   * Returns the plan that fits into the time.
   *
   * @param rate samples per second of all threads
   * @param spent seconds so far
   * @param settings number of settings
   */
  public TradePlan plan(double rate, double spent, int settings, RenderSettings frame) {
    double time = RENDERING * seconds - spent;
    if (samples.isEmpty()) {
      int processors = Runtime.getRuntime().availableProcessors();
      double exact = EXACT_SHARE * affordable(rate, spent, frame) / EXACT_RENDERS / processors;
      return plan(mostSamples(rate, spent, settings, frame), LEAST_SEEDS, exact, time);
    }
    double exact = samples.get() / (double) STEP;
    return plan(samples.get(), MOST_SEEDS / 2, exact, Double.POSITIVE_INFINITY);
  }

  private int mostSamples(double rate, double spent, int settings, RenderSettings frame) {
    double each = (double) settings * seeds.orElse(PLANNED_SEEDS) + REFERENCE_FACTOR;
    return powerOfTwo(PLANNED * affordable(rate, spent, frame) / each, LARGEST);
  }

  /** Returns the number of samples per pixel that fit into the time. */
  private double affordable(double rate, double spent, RenderSettings frame) {
    return rate * (seconds - spent) / ((double) frame.width() * frame.height());
  }

  /** Returns the largest power of two that is at most a number, clamped to 1 and a limit. */
  private static int powerOfTwo(double number, int limit) {
    return Integer.highestOneBit((int) Math.max(1, Math.min(number, limit)));
  }

  private TradePlan plan(int most, int leastSeeds, double exactSamples, double time) {
    List<Integer> ladder = new ArrayList<>();
    for (int at = most; at >= 1; at /= STEP) {
      ladder.add(at);
    }
    Collections.reverse(ladder);
    int least = seeds.orElse(leastSeeds);
    return new TradePlan(
        ladder,
        least,
        seeds.orElse(Math.max(least, MOST_SEEDS)),
        reference.orElse(REFERENCE_FACTOR * most),
        powerOfTwo(exactSamples, MOST_EXACT_SAMPLES),
        time);
  }
}
