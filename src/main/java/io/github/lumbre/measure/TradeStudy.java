package io.github.lumbre.measure;

import io.github.lumbre.image.Image;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassResult;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.SampleTarget;
import io.github.lumbre.render.Schedule;
import io.github.lumbre.scene.RenderSettings;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.DoubleSupplier;

/**
 * Measures what settings cost and how wrong they are: renders a reference, and each setting with
 * several seeds at each number of samples. Settings take turns within each seed, so that what
 * happens on the machine meanwhile falls on all of them.
 */
public final class TradeStudy {
  /** Differs from all seeds of the study in every bit that matters. */
  private static final long REFERENCE_SEED = 0x5eed_0f_7e_fe_7e_9ceL;

  private static final double CONFIDENCE = .95;

  private static final int FRAME_FOR_COUNTERS = 20_000;

  private final List<TradeSetting> settings;
  private final TradePlan plan;
  private final DoubleSupplier cpuSeconds;
  private final Consumer<String> log;
  private final List<Trial> trials = new ArrayList<>();

  /** One render of one setting with one seed, up to one number of samples. */
  private record Trial(
      TradeSetting setting,
      int samples,
      double seconds,
      double cpu,
      PictureError error,
      Image picture) {}

  /**
   * @param settings to be measured, that which is taken for the truth first
   * @param cpuSeconds tells the processor time of the process so far
   * @param log hears what is being done
   */
  public TradeStudy(
      List<TradeSetting> settings,
      TradePlan plan,
      DoubleSupplier cpuSeconds,
      Consumer<String> log) {
    this.settings = List.copyOf(settings);
    this.plan = plan;
    this.cpuSeconds = cpuSeconds;
    this.log = log;
  }

  /**
   * Runs the study.
   *
   * @throws InterruptedException if the calling thread is interrupted
   */
  public TradeResult run() throws InterruptedException {
    double start = seconds();
    log.accept("reference: " + plan.referenceSamples() + " samples per pixel");
    FilmRenderer renderer = reference().renderer(REFERENCE_SEED);
    Film film = renderer.newFilm();
    climb(renderer, film, plan.referenceSamples());
    Image truth = film.develop();
    NoiseEstimate noise = NoiseEstimator.of(film, CONFIDENCE).orElseThrow();
    log.accept("settings that change the time alone");
    List<ExactRow> exact = new ExactPairs(reference(), plan.exactSamples(), cpuSeconds).rows();
    renderSeeds(start, truth);
    log.accept("nodes and textures");
    List<TradeRow> rows = new ArrayList<>();
    for (TradeSetting setting : settings) {
      TradeWork work = work(setting);
      for (int samples : plan.ladder()) {
        rows.add(row(setting, samples, work, truth, noise.relativeMse()));
      }
    }
    return new TradeResult(truth, plan.referenceSamples(), noise, rows, exact);
  }

  private static double seconds() {
    return System.nanoTime() * 1e-9;
  }

  private TradeSetting reference() {
    return settings.get(0);
  }

  /** Renders as many seeds as the time allows. */
  private void renderSeeds(double start, Image truth) throws InterruptedException {
    double longest = 0;
    for (int seed = 0; seed < plan.mostSeeds(); seed++) {
      double begin = seconds();
      if (seed >= plan.leastSeeds() && begin + longest - start > plan.seconds()) {
        break;
      }
      log.accept("seed " + (seed + 1) + ": " + settings.size() + " settings");
      for (TradeSetting setting : settings) {
        render(setting, seed, truth);
      }
      longest = Math.max(longest, seconds() - begin);
    }
  }

  /** Adds samples, in growing passes, until each pixel has so many. */
  static RenderStatistics climb(FilmRenderer renderer, Film film, int goal)
      throws InterruptedException {
    RenderStatistics statistics = RenderStatistics.ZERO;
    Schedule schedule = renderer.schedule(goal);
    for (Optional<SampleTarget> target = schedule.next(film);
        target.isPresent();
        target = schedule.next(film)) {
      PassResult pass = renderer.addSamples(film, target.get(), Progress.NONE);
      statistics = statistics.plus(pass.statistics());
    }
    return statistics;
  }

  private void render(TradeSetting setting, int seed, Image truth) throws InterruptedException {
    FilmRenderer renderer = setting.renderer(1L + seed);
    Film film = renderer.newFilm();
    double seconds = 0;
    double cpu = 0;
    for (int samples : plan.ladder()) {
      double cpuStart = cpuSeconds.getAsDouble();
      double start = seconds();
      climb(renderer, film, samples);
      seconds += seconds() - start;
      cpu += cpuSeconds.getAsDouble() - cpuStart;
      Image picture = film.develop();
      trials.add(
          new Trial(setting, samples, seconds, cpu, PictureError.of(picture, truth), picture));
    }
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
    RenderStatistics statistics = climb(renderer, film, samples);
    double all = (double) samples * pixels;
    return new TradeWork(
        statistics.rays() / all,
        statistics.shadowRays() / all,
        scene.nodes().sum() / all,
        scene.lookUps().sum() / all);
  }

  private TradeRow row(
      TradeSetting setting, int samples, TradeWork work, Image truth, double truthNoise) {
    List<Trial> own =
        trials.stream().filter(t -> t.setting == setting && t.samples == samples).toList();
    return new TradeRow(
        setting,
        samples,
        own.stream().map(Trial::seconds).toList(),
        own.stream().map(Trial::cpu).toList(),
        own.stream().map(Trial::error).toList(),
        work,
        bias(own.stream().map(Trial::picture).toList(), truth, truthNoise),
        own.get(0).picture);
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
    double half = StudentT.critical(CONFIDENCE, count - 1) * error;
    return new TradeRow.Bias(all, all - half, all + half);
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
