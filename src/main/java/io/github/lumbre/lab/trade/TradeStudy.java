package io.github.lumbre.lab.trade;

import io.github.lumbre.image.Image;
import io.github.lumbre.lab.metrics.PictureError;
import io.github.lumbre.lab.metrics.StudentT;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.stopping.Budget;
import io.github.lumbre.stopping.NoiseEstimate;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.DoubleFunction;
import java.util.function.DoubleSupplier;

/**
 * Measures what settings cost and how wrong they are: renders a reference, and each setting with
 * several seeds at each number of samples. Settings take turns within each seed, so that what
 * happens on the machine meanwhile falls on all of them.
 */
public final class TradeStudy {
  /** Differs from all seeds of the study in every bit that matters. */
  private static final long REFERENCE_SEED = 0x5eed_0f_7e_fe_7e_9ceL;

  private static final int FRAME_FOR_COUNTERS = 20_000;

  /** The share of the time after which a reference is taken as it is. */
  private static final double REFERENCE_SHARE = .5;

  private final TradeSweep sweep;
  private final DoubleFunction<TradePlan> planner;
  private final DoubleSupplier cpuSeconds;
  private final Consumer<String> log;
  private final List<TradeTrial> trials = new ArrayList<>();

  /** The usual setting's films, one for each seed. */
  private final List<TradeClimb> usual = new ArrayList<>();

  private TradePlan plan;
  private List<TradeSetting> settings;
  private double start;

  /**
   * @param sweep settings to be measured
   * @param planner tells what fits if so many samples a second are rendered
   * @param cpuSeconds tells the processor time of the process so far
   * @param log hears what is being done
   */
  public TradeStudy(
      TradeSweep sweep,
      DoubleFunction<TradePlan> planner,
      DoubleSupplier cpuSeconds,
      Consumer<String> log) {
    this.sweep = sweep;
    this.planner = planner;
    this.cpuSeconds = cpuSeconds;
    this.log = log;
  }

  /**
   * Runs the study. Not to be called twice.
   *
   * @param rate samples that are rendered in a second, as far as that is known; the reference tells
   *     it better
   * @throws InterruptedException if the calling thread is interrupted
   */
  public TradeResult run(double rate) throws InterruptedException {
    start = TradeClimb.clock();
    planFor(rate);
    TradeClimb reference = renderReference();
    planAgain(reference);
    Image truth = reference.film().develop();
    NoiseEstimate noise = noise(reference);
    log.accept("settings that change the time alone");
    List<ExactRow> exact = new ExactPairs(reference(), plan.exactSamples(), cpuSeconds).rows();
    renderSeeds(truth);
    reachTarget(truth, noise.relativeMse());
    log.accept("nodes and textures");
    return new TradeResult(
        truth, reference.samples(), noise, rows(truth, noise.relativeMse()), exact);
  }

  private void planFor(double rate) {
    plan = planner.apply(rate);
    settings = sweep.settings(plan.mostSamples());
  }

  /** Plans by the time that the reference took, and goes on with it if it is to be better. */
  private void planAgain(TradeClimb reference) throws InterruptedException {
    Film film = reference.film();
    planFor(film.totalSamples() / Math.max(1e-9, reference.seconds()));
    if (plan.referenceSamples() > reference.samples()) {
      log.accept("reference: " + plan.referenceSamples() + " samples per pixel");
      reference.to(plan.referenceSamples());
    }
  }

  private List<TradeRow> rows(Image truth, double truthNoise) throws InterruptedException {
    List<TradeRow> rows = new ArrayList<>();
    for (TradeSetting setting : settings) {
      TradeWork work = work(setting);
      int[] ladder =
          trials.stream()
              .filter(t -> t.setting() == setting)
              .mapToInt(TradeTrial::samples)
              .distinct()
              .toArray();
      for (int samples : ladder) {
        rows.add(row(setting, samples, work, truth, truthNoise));
      }
    }
    return rows;
  }

  private TradeSetting reference() {
    return settings.get(0);
  }

  private static NoiseEstimate noise(TradeClimb climb) {
    return NoiseEstimate.of(climb.film(), Budget.CONFIDENCE).orElseThrow();
  }

  /**
   * Renders what all is compared with: if there is an error to be reached, until its own is small
   * beside that, or half of the time is over.
   */
  private TradeClimb renderReference() throws InterruptedException {
    TradeClimb climb = new TradeClimb(reference(), REFERENCE_SEED, cpuSeconds);
    double wanted = plan.targetRelativeMse() / TradePlan.REFERENCE_MARGIN;
    for (int goal = plan.referenceSamples(); ; goal = afterwards(goal)) {
      log.accept("reference: " + goal + " samples per pixel");
      climb.to(goal);
      int next = afterwards(goal);
      double further = climb.seconds() * (next - goal) / goal;
      if (!plan.hasTarget()
          || noise(climb).upperRelativeMse() <= wanted
          || next > TradePlan.LIMIT
          || !fits(further, REFERENCE_SHARE)) {
        return climb;
      }
    }
  }

  /** Returns the next power of two, or half as much again of one. */
  private static int afterwards(int samples) {
    int power = Integer.highestOneBit(samples);
    return samples == power ? power + power / 2 : 2 * power;
  }

  /** Tells whether what takes so long ends within a share of the time. */
  private boolean fits(double seconds, double share) {
    return TradeClimb.clock() + seconds - start <= share * plan.seconds();
  }

  /** Renders as many seeds as the time allows. */
  private void renderSeeds(Image truth) throws InterruptedException {
    double longest = 0;
    for (int seed = 0; seed < plan.mostSeeds(); seed++) {
      double begin = TradeClimb.clock();
      if (seed >= plan.leastSeeds() && !fits(longest, 1)) {
        break;
      }
      log.accept("seed " + (seed + 1) + ": " + settings.size() + " settings");
      for (TradeSetting setting : settings) {
        render(setting, seed, truth);
      }
      longest = Math.max(longest, TradeClimb.clock() - begin);
    }
  }

  private void render(TradeSetting setting, int seed, Image truth) throws InterruptedException {
    TradeClimb climb = new TradeClimb(setting, 1L + seed, cpuSeconds);
    for (int samples : plan.ladder()) {
      climb.to(samples);
      trials.add(climb.against(truth));
    }
    if (setting == reference() && plan.hasTarget()) {
      usual.add(climb);
    }
  }

  /**
   * Doubles the samples of the usual setting until every seed's error is small enough, or the time
   * is over. Each of the seeds' films is as far as the others, so that the means tell something.
   */
  private void reachTarget(Image truth, double truthNoise) throws InterruptedException {
    for (int samples = 2 * plan.mostSamples();
        plan.hasTarget() && samples <= TradePlan.LIMIT && !isReached(truthNoise);
        samples *= 2) {
      if (!fits(usual.stream().mapToDouble(TradeClimb::seconds).sum(), 1)) {
        log.accept("no time for " + samples + " samples per pixel");
        return;
      }
      log.accept("usual setting: " + samples + " samples per pixel");
      for (TradeClimb climb : usual) {
        climb.to(samples);
        trials.add(climb.against(truth));
      }
    }
  }

  /** Tells whether the last trials of the usual setting all have the error that is wanted. */
  private boolean isReached(double truthNoise) {
    int samples = usual.get(0).samples();
    return trials.stream()
        .filter(t -> t.setting() == reference() && t.samples() == samples)
        .allMatch(t -> t.error().relativeMse() - truthNoise <= plan.targetRelativeMse());
  }

  /** Counts the work of a sample: of one in each pixel, or more where there are few. */
  private static TradeWork work(TradeSetting setting) throws InterruptedException {
    TradeScene scene = setting.scene();
    RenderSettings frame = setting.settings().toBuilder().seed(1).build();
    int pixels = frame.window().width() * frame.window().height();
    int samples = Math.max(1, FRAME_FOR_COUNTERS / pixels);
    FilmRenderer renderer = setting.renderer(scene.counting(), frame);
    Film film = renderer.newFilm();
    // Domes look at their textures when they are made: only what follows counts.
    scene.nodes().reset();
    scene.lookUps().reset();
    RenderStatistics statistics = TradeClimb.climb(renderer, film, samples);
    double all = (double) samples * pixels;
    return new TradeWork(
        statistics.rays() / all,
        statistics.shadowRays() / all,
        scene.nodes().sum() / all,
        scene.lookUps().sum() / all);
  }

  private TradeRow row(
      TradeSetting setting, int samples, TradeWork work, Image truth, double truthNoise) {
    List<TradeTrial> own =
        trials.stream().filter(t -> t.setting() == setting && t.samples() == samples).toList();
    return new TradeRow(
        setting,
        samples,
        own.stream().map(TradeTrial::seconds).toList(),
        own.stream().map(TradeTrial::cpu).toList(),
        own.stream().map(TradeTrial::error).toList(),
        work,
        bias(own.stream().map(TradeTrial::picture).toList(), truth, truthNoise),
        own.get(0).picture());
  }

  /** Returns the bias of pictures of independent seeds, its interval by the jackknife. */
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

  /** Returns the mean of ((m − r)² − s²/K) / (r² + 0.01), one picture left out. */
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
