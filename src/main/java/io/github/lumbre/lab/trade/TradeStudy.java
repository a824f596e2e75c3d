package io.github.lumbre.lab.trade;

import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.compare.PictureError;
import io.github.lumbre.lab.Cost;
import io.github.lumbre.lab.Trial;
import io.github.lumbre.lab.metrics.StudentT;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.stopping.Budget;
import io.github.lumbre.render.stopping.NoiseEstimate;
import io.github.lumbre.scene.RenderSettings;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.DoubleFunction;
import java.util.stream.Collectors;

/**
 * Measures the time and error of settings: renders a reference, and each setting with several seeds
 * at each number of samples. Within each seed the settings alternate, so that other load on the
 * machine affects all of them.
 */
public final class TradeStudy {
  /** A seed that differs from all seeds of the study. */
  private static final long REFERENCE_SEED = 0x5eed_0f_7e_fe_7e_9ceL;

  private static final int FRAME_FOR_COUNTERS = 20_000;

  private final TradeSweep sweep;
  private final DoubleFunction<TradePlan> planner;
  private final Consumer<String> log;
  private final List<TradeShot> shots = new ArrayList<>();

  private TradePlan plan;
  private List<TradeSetting> settings;
  private Cost start;

  /**
   * @param sweep settings to measure
   * @param planner returns the plan for a rate in samples per second
   * @param log receives progress messages
   */
  public TradeStudy(TradeSweep sweep, DoubleFunction<TradePlan> planner, Consumer<String> log) {
    this.sweep = sweep;
    this.planner = planner;
    this.log = log;
  }

  /**
   * Runs the study. Must be called only once.
   *
   * @param rate estimate of the samples per second; the reference refines it
   * @throws InterruptedException if the calling thread is interrupted
   */
  public TradeResult run(double rate) throws InterruptedException {
    start = Cost.now();
    planFor(rate);
    Trial reference = new Trial(reference().renderer(REFERENCE_SEED), Progress.NONE);
    renderReference(reference);
    planAgain(reference);
    Image truth = reference.film().develop();
    NoiseEstimate noise = NoiseEstimate.of(reference.film(), Budget.CONFIDENCE).orElseThrow();
    log.accept("settings that change only the time");
    List<ExactRow> exact = ExactRow.all(reference(), plan.exactSamples());
    renderSeeds(truth);
    log.accept("counting BVH nodes and texture look-ups");
    return new TradeResult(
        truth, reference.samples(), noise, rows(truth, noise.relativeMse()), exact);
  }

  private void planFor(double rate) {
    plan = planner.apply(rate);
    settings = sweep.settings(plan.mostSamples());
  }

  /**
   * Plans again by the reference's rate, and adds samples to the reference if the plan has more.
   */
  private void planAgain(Trial reference) throws InterruptedException {
    double seconds = Math.max(1e-9, reference.cost().seconds());
    planFor(reference.film().totalSamples() / seconds);
    if (plan.referenceSamples() > reference.samples()) {
      renderReference(reference);
    }
  }

  private void renderReference(Trial reference) throws InterruptedException {
    log.accept("reference: " + Numbers.count(plan.referenceSamples(), "sample") + " per pixel");
    reference.to(plan.referenceSamples());
  }

  private List<TradeRow> rows(Image truth, double truthNoise) throws InterruptedException {
    List<TradeRow> rows = new ArrayList<>();
    for (TradeSetting setting : settings) {
      TradeWork work = work(setting);
      shots.stream()
          .filter(shot -> shot.setting() == setting)
          .collect(Collectors.groupingBy(TradeShot::samples, TreeMap::new, Collectors.toList()))
          .values()
          .forEach(seeds -> rows.add(row(seeds, work, truth, truthNoise)));
    }
    return rows;
  }

  private static TradeRow row(
      List<TradeShot> seeds, TradeWork work, Image truth, double truthNoise) {
    List<Image> pictures = seeds.stream().map(TradeShot::picture).toList();
    return new TradeRow(seeds, work, bias(pictures, truth, truthNoise));
  }

  private TradeSetting reference() {
    return settings.get(0);
  }

  /** Returns whether work of a given duration ends within the time. */
  private boolean fits(double seconds) {
    return Cost.since(start).seconds() + seconds <= plan.seconds();
  }

  /** Renders as many seeds as the time allows. */
  private void renderSeeds(Image truth) throws InterruptedException {
    double longest = 0;
    for (int seed = 0; seed < plan.mostSeeds(); seed++) {
      Cost begin = Cost.now();
      if (seed >= plan.leastSeeds() && !fits(longest)) {
        break;
      }
      log.accept("seed " + (seed + 1) + ": " + settings.size() + " settings");
      for (TradeSetting setting : settings) {
        render(setting, seed, truth);
      }
      longest = Math.max(longest, Cost.since(begin).seconds());
    }
  }

  private void render(TradeSetting setting, int seed, Image truth) throws InterruptedException {
    Trial trial = new Trial(setting.renderer(1L + seed), Progress.NONE);
    for (int samples : plan.ladder()) {
      if (samples >= setting.leastSamples()) {
        trial.to(samples);
        shots.add(shot(setting, trial, seed + 1, truth));
      }
    }
  }

  private static TradeShot shot(TradeSetting setting, Trial trial, int seed, Image truth)
      throws InterruptedException {
    Cost begin = Cost.now();
    Image picture = setting.develop(trial.film());
    Cost cost = trial.cost().plus(Cost.since(begin));
    PictureError error = PictureError.of(picture, truth);
    return new TradeShot(setting, trial.samples(), seed, cost, error, picture);
  }

  /** Counts the work per sample, with one sample per pixel, or more for small frames. */
  private static TradeWork work(TradeSetting setting) throws InterruptedException {
    TradeScene scene = setting.scene();
    RenderSettings frame = setting.settings().toBuilder().seed(1).build();
    int pixels = frame.window().width() * frame.window().height();
    int samples = Math.max(1, FRAME_FOR_COUNTERS / pixels);
    Trial trial = new Trial(setting.renderer(scene.counting(), frame), Progress.NONE);
    // Environment lights read their textures when they are created; do not count these look-ups.
    scene.nodes().reset();
    scene.lookUps().reset();
    trial.to(samples);
    RenderStatistics statistics = trial.statistics();
    double all = (double) samples * pixels;
    return new TradeWork(
        statistics.rays() / all,
        statistics.shadowRays() / all,
        scene.nodes().sum() / all,
        scene.lookUps().sum() / all);
  }

  /** Returns the bias of pictures of independent seeds, with its interval by the jackknife. */
  static TradeRow.Bias bias(List<Image> pictures, Image truth, double truthNoise) {
    int count = pictures.size();
    double[][] seen = pictures.stream().map(PictureError::seen).toArray(double[][]::new);
    double[] r = PictureError.seen(truth);
    double all = squaredBias(seen, -1, r) - truthNoise;
    if (count < 3) {
      return new TradeRow.Bias(all, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    }
    double[] without = new double[count];
    for (int i = 0; i < count; i++) {
      without[i] = squaredBias(seen, i, r) - truthNoise;
    }
    double mean = Arrays.stream(without).sum() / count;
    double squares = Arrays.stream(without).map(v -> (v - mean) * (v - mean)).sum();
    double error = Math.sqrt(squares * (count - 1) / count);
    double half = StudentT.critical(Budget.CONFIDENCE, count - 1) * error;
    return new TradeRow.Bias(all, all - half, Math.max(all + half, truthNoise));
  }

  /** Returns the mean of ((m − r)² − s²/K) / (r² + 0.01), without one of the pictures. */
  private static double squaredBias(double[][] pictures, int left, double[] r) {
    int count = left < 0 ? pictures.length : pictures.length - 1;
    double sum = 0;
    for (int i = 0; i < r.length; i++) {
      double mean = 0;
      for (int k = 0; k < pictures.length; k++) {
        mean += k == left ? 0 : pictures[k][i] / count;
      }
      double squares = 0;
      for (int k = 0; k < pictures.length; k++) {
        double off = pictures[k][i] - mean;
        squares += k == left ? 0 : off * off;
      }
      double noise = squares / (count - 1) / count;
      double off = mean - r[i];
      sum += (off * off - noise) / (r[i] * r[i] + PictureError.FLOOR);
    }
    return sum / r.length;
  }
}
