package io.github.lumbre.lab.trade;

import io.github.lumbre.lab.perf.SampleBudget;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Size;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/**
 * How long a study may take, and what that comes to.
 *
 * @param seconds from the start, the page included
 * @param samples the most per pixel of a setting; then the time does not count, but for a target
 * @param target relative root mean squared error that the usual setting is to reach, with as many
 *     samples as that takes and the time allows; samples are to be given then
 * @param reference samples per pixel of the reference, at least those if there is a target;
 *     otherwise 64 times those of a setting
 * @param seeds of each setting; otherwise as many as fit into the time
 * @param size of the frame, if it is not to be the scene's, shrunk
 * @param isQuick whether the frame is to be smaller still
 */
public record TradeBudget(
    double seconds,
    Optional<Integer> samples,
    Optional<Double> target,
    Optional<Integer> reference,
    Optional<Integer> seeds,
    Optional<Size> size,
    boolean isQuick) {
  /** The most samples per pixel of a setting. */
  public static final int LARGEST = 1 << 20;

  private static final int PAGE_SIDE = 160;
  private static final int QUICK_SIDE = 96;
  private static final int LEAST_SIDE = 48;

  /** With less than so many samples at most, a smaller frame tells more. */
  private static final int WORTHWHILE = 16;

  /** How many settings there are at most, or about. */
  private static final int MANY_SETTINGS = 20;

  /** How many seeds are planned for; fewer, but these, where time runs out. */
  private static final int PLANNED_SEEDS = 4;

  private static final int LEAST_SEEDS = 3;
  private static final int MOST_SEEDS = 32;

  /** How many times as many samples as a setting's most the reference has. */
  private static final int REFERENCE_FACTOR = 64;

  /**
   * The share of the time that is planned for by the pilot's rate: what is left if the machine has
   * more to do meanwhile, and goes into more seeds if it has not.
   */
  private static final double PLANNED = .6;

  /** The share after which no seed begins that would end beyond; the rest is for the page. */
  private static final double RENDERING = .85;

  /** Renders of one thread that compare exact settings, and the share of the time for them. */
  private static final int EXACT_RENDERS = 50;

  private static final double EXACT_SHARE = .1;
  private static final int MOST_EXACT_SAMPLES = 16;
  private static final int STEP = 4;

  /**
   * Returns settings with the frame of a study: the one asked for, or the scene's, shrunk to a side
   * of 160 pixels, or of 96 if it is to be quick; further where time is short.
   *
   * @param rate samples per second of all threads
   */
  public RenderSettings framed(RenderSettings settings, double rate) {
    if (size.isPresent()) {
      return settings.toBuilder().size(size.get().width(), size.get().height()).build();
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
   * Returns as much work as fits.
   *
   * @param rate samples per second of all threads
   * @param spent seconds so far
   * @param settings how many are measured
   */
  public TradePlan plan(double rate, double spent, int settings, RenderSettings frame) {
    if (samples.isPresent()) {
      int exact = powerOfTwo(samples.get() / (double) STEP, MOST_EXACT_SAMPLES);
      int least = target.isPresent() ? PLANNED_SEEDS : MOST_SEEDS / 2;
      double time = target.isPresent() ? RENDERING * seconds - spent : Double.POSITIVE_INFINITY;
      return plan(samples.get(), seeds.orElse(least), exact, time);
    }
    int processors = Runtime.getRuntime().availableProcessors();
    double exact = EXACT_SHARE * affordable(rate, spent, frame) / EXACT_RENDERS / processors;
    return plan(
        mostSamples(rate, spent, settings, frame),
        LEAST_SEEDS,
        powerOfTwo(exact, MOST_EXACT_SAMPLES),
        RENDERING * seconds - spent);
  }

  private int mostSamples(double rate, double spent, int settings, RenderSettings frame) {
    double each = (double) settings * seeds.orElse(PLANNED_SEEDS) + REFERENCE_FACTOR;
    return powerOfTwo(PLANNED * affordable(rate, spent, frame) / each, LARGEST);
  }

  /** Returns how many samples of each pixel fit into the time. */
  private double affordable(double rate, double spent, RenderSettings frame) {
    return rate * (seconds - spent) / ((double) frame.width() * frame.height());
  }

  /** Returns the largest power of two that is not above a number, from 1 to a limit. */
  private static int powerOfTwo(double number, int limit) {
    return Integer.highestOneBit((int) Math.max(1, Math.min(number, limit)));
  }

  private TradePlan plan(int most, int leastSeeds, int exactSamples, double time) {
    List<Integer> ladder = new ArrayList<>();
    for (int at = most; at >= 1; at /= STEP) {
      ladder.add(at);
    }
    Collections.reverse(ladder);
    int least = seeds.orElse(leastSeeds);
    int mostSeeds = target.isPresent() ? least : Math.max(least, MOST_SEEDS);
    return new TradePlan(
        ladder,
        least,
        seeds.orElse(mostSeeds),
        reference.orElse(REFERENCE_FACTOR * most),
        exactSamples,
        time,
        target.map(error -> error * error).orElse(0.));
  }
}
