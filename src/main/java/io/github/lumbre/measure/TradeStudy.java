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

  private static final int EXACT_PAIRS = 5;
  private static final double CONFIDENCE = .95;

  private final TradeSetting reference;
  private final List<TradeSetting> settings;
  private final Plan plan;
  private final DoubleSupplier cpuSeconds;
  private final Consumer<String> log;
  private final List<Trial> trials = new ArrayList<>();

  /**
   * How much is rendered.
   *
   * @param ladder numbers of samples per pixel, ascending
   * @param seeds of each setting, at least 2
   * @param referenceSamples per pixel
   */
  public record Plan(List<Integer> ladder, int seeds, int referenceSamples) {
    public Plan {
      ladder = List.copyOf(ladder);
      if (ladder.isEmpty() || seeds < 2 || referenceSamples < 2) {
        throw new IllegalArgumentException("plan: expected samples and at least two seeds");
      }
    }

    /** Returns samples per pixel of all renders together. */
    public long samples(int settings) {
      return (long) settings * seeds * ladder.get(ladder.size() - 1) + referenceSamples;
    }
  }

  /** One render of one setting with one seed, up to one number of samples. */
  private record Trial(
      TradeSetting setting,
      int samples,
      double seconds,
      double cpu,
      RenderStatistics statistics,
      PictureError error,
      Image picture) {}

  /**
   * @param reference the setting that is taken for the truth
   * @param settings to be measured
   * @param cpuSeconds tells the processor time of the process so far
   * @param log hears what is being done
   */
  public TradeStudy(
      TradeSetting reference,
      List<TradeSetting> settings,
      Plan plan,
      DoubleSupplier cpuSeconds,
      Consumer<String> log) {
    this.reference = reference;
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
    log.accept("reference: " + plan.referenceSamples + " samples per pixel");
    FilmRenderer renderer =
        new FilmRenderer(seeded(reference.settings(), REFERENCE_SEED), reference.scene());
    Film film = renderer.newFilm();
    climb(renderer, film, plan.referenceSamples);
    Image truth = film.develop();
    NoiseEstimate noise = NoiseEstimator.of(film, CONFIDENCE).orElseThrow();
    for (int seed = 0; seed < plan.seeds; seed++) {
      log.accept("seed " + (seed + 1) + " of " + plan.seeds + ": " + settings.size() + " settings");
      for (TradeSetting setting : settings) {
        render(setting, seed, truth);
      }
    }
    List<TradeRow> rows = new ArrayList<>();
    for (TradeSetting setting : settings) {
      for (int samples : plan.ladder) {
        rows.add(row(setting, samples, truth, noise.relativeMse()));
      }
    }
    log.accept("threads and buckets: " + EXACT_PAIRS + " pairs each");
    return new TradeResult(truth, plan.referenceSamples, noise, rows, exact());
  }

  private static RenderSettings seeded(RenderSettings settings, long seed) {
    return settings.toBuilder().seed(seed).build();
  }

  private static RenderStatistics climb(FilmRenderer renderer, Film film, int goal)
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
    FilmRenderer renderer =
        new FilmRenderer(seeded(setting.settings(), 1L + seed), setting.scene());
    Film film = renderer.newFilm();
    RenderStatistics statistics = RenderStatistics.ZERO;
    double seconds = 0;
    double cpu = 0;
    for (int samples : plan.ladder) {
      double cpuStart = cpuSeconds.getAsDouble();
      long start = System.nanoTime();
      statistics = statistics.plus(climb(renderer, film, samples));
      seconds += (System.nanoTime() - start) * 1e-9;
      cpu += cpuSeconds.getAsDouble() - cpuStart;
      Image picture = film.develop();
      PictureError error = PictureError.of(picture, truth);
      trials.add(new Trial(setting, samples, seconds, cpu, statistics, error, picture));
    }
  }

  private TradeRow row(TradeSetting setting, int samples, Image truth, double truthNoise) {
    List<Trial> own =
        trials.stream().filter(t -> t.setting == setting && t.samples == samples).toList();
    return new TradeRow(
        setting,
        samples,
        own.stream().map(Trial::seconds).toList(),
        own.stream().map(Trial::cpu).toList(),
        own.stream().map(Trial::error).toList(),
        own.stream().mapToDouble(t -> t.statistics.rays()).average().orElse(0),
        own.stream().mapToDouble(t -> t.statistics.shadowRays()).average().orElse(0),
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

  private List<ExactRow> exact() throws InterruptedException {
    RenderSettings base = reference.settings().toBuilder().threads(1).bucketSize(32).build();
    int processors = Runtime.getRuntime().availableProcessors();
    List<ExactRow> rows = new ArrayList<>();
    if (processors > 1) {
      RenderSettings many = base.toBuilder().threads(processors).build();
      rows.add(pairs("threads " + processors + " / 1", base, many));
    }
    for (int bucket : new int[] {8, 128}) {
      RenderSettings other = base.toBuilder().bucketSize(bucket).build();
      rows.add(pairs("bucket " + bucket + " / 32", base, other));
    }
    return rows;
  }

  private ExactRow pairs(String name, RenderSettings base, RenderSettings other)
      throws InterruptedException {
    List<Double> ratios = new ArrayList<>();
    boolean same = true;
    for (int pair = 0; pair < EXACT_PAIRS; pair++) {
      // In the order ABBA, lest a drift favours one of them.
      boolean swap = pair % 2 == 1;
      Timed first = timed(swap ? other : base);
      Timed second = timed(swap ? base : other);
      double ratio = second.seconds / first.seconds;
      ratios.add(swap ? 1 / ratio : ratio);
      same &= Arrays.equals(first.picture.rgb(), second.picture.rgb());
    }
    return new ExactRow(name, Interval.ofMean(ratios), same);
  }

  private record Timed(double seconds, Image picture) {}

  private Timed timed(RenderSettings settings) throws InterruptedException {
    FilmRenderer renderer = new FilmRenderer(settings, reference.scene());
    Film film = renderer.newFilm();
    int samples = Math.min(16, plan.ladder.get(plan.ladder.size() - 1));
    long start = System.nanoTime();
    climb(renderer, film, samples);
    return new Timed((System.nanoTime() - start) * 1e-9, film.develop());
  }
}
