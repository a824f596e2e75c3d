package io.github.lumbre.lab.trade;

import io.github.lumbre.image.Image;
import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.compare.PictureError;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.stopping.Budget;
import io.github.lumbre.stopping.BudgetRenderer;
import io.github.lumbre.stopping.NoiseEstimate;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Measures the error of renders that end at a target error, with a given depth and several seeds.
 * The reference has a large depth.
 */
public final class QualityStudy {
  /** Differs from all seeds of the study. */
  private static final long REFERENCE_SEED = -1;

  /** A depth that Russian roulette hardly ever lets a path reach. */
  private static final int DEEP = 1000;

  private static final int FEWEST_SAMPLES = 64;

  private final Scene scene;
  private final RenderSettings settings;
  private final double end;
  private final Image truth;
  private final Film reference;
  private final double referenceNoise;

  /**
   * The result for one quality.
   *
   * @param samples samples per pixel, mean over the seeds
   * @param error relative mean squared error, without the reference's own
   * @param largest largest error of all seeds, without the reference's own
   * @param bias error that more samples do not reduce
   */
  public record Row(Interval samples, Interval error, double largest, TradeRow.Bias bias) {}

  /**
   * Renders the reference.
   *
   * @param settings settings for path tracing
   * @param relativeMse target relative mean squared error of the reference
   * @param seconds time for the whole study; the reference takes at most half of it
   * @throws InterruptedException if the calling thread is interrupted
   */
  public QualityStudy(Scene scene, RenderSettings settings, double relativeMse, double seconds)
      throws InterruptedException {
    this.scene = scene;
    this.settings = settings;
    double start = TradeClimb.clock();
    end = start + seconds;
    FilmRenderer renderer = renderer(DEEP, REFERENCE_SEED);
    reference = renderer.newFilm();
    // Render these samples regardless of the time, so that there is always a reference.
    TradeClimb.climb(renderer, reference, FEWEST_SAMPLES);
    render(renderer, reference, Math.sqrt(relativeMse), start + seconds / 2);
    truth = reference.develop();
    referenceNoise = NoiseEstimate.of(reference, Budget.CONFIDENCE).orElseThrow().relativeMse();
  }

  private FilmRenderer renderer(int depth, long seed) {
    return new FilmRenderer(
        settings.toBuilder().maxTraceDepth(depth).adaptive(false).seed(seed).build(), scene);
  }

  /** Renders until a target error or a deadline. Returns whether the error was reached. */
  private static boolean render(FilmRenderer renderer, Film film, double error, double deadline)
      throws InterruptedException {
    Budget budget =
        new Budget(RenderSettings.MAX_SAMPLES, OptionalDouble.of(error), Budget.CONFIDENCE);
    Progress until = Progress.NONE.cancelledAlsoIf(() -> TradeClimb.clock() > deadline);
    return new BudgetRenderer(renderer, budget).render(film, until).reachedTarget();
  }

  /**
   * Renders with a target error and a depth.
   *
   * @param error relative root mean squared error at which each render ends
   * @param seeds number of seeds, at least 3
   * @return the result; empty if the time does not suffice
   * @throws InterruptedException if the calling thread is interrupted
   */
  public Optional<Row> measure(double error, int depth, int seeds) throws InterruptedException {
    List<Double> samples = new ArrayList<>();
    List<Double> errors = new ArrayList<>();
    List<Image> pictures = new ArrayList<>();
    for (int seed = 1; seed <= seeds; seed++) {
      FilmRenderer renderer = renderer(depth, seed);
      Film film = renderer.newFilm();
      if (!render(renderer, film, error, end)) {
        return Optional.empty();
      }
      Image picture = film.develop();
      samples.add(film.meanSamples());
      errors.add(PictureError.of(picture, truth).relativeMse() - referenceNoise);
      pictures.add(picture);
    }
    return Optional.of(
        new Row(
            Interval.ofMean(samples),
            Interval.ofMean(errors),
            errors.stream().mapToDouble(e -> e).max().orElseThrow(),
            TradeStudy.bias(pictures, truth, referenceNoise)));
  }

  /** Returns the table cells of a row: samples, error, largest error, bias. */
  public static List<String> cells(Row row) {
    TradeRow.Bias bias = row.bias;
    return List.of(
        String.format(Locale.ROOT, "%.0f", row.samples.value()),
        TradeText.rootPercent(row.error.value()),
        TradeText.rootPercent(row.largest),
        bias.isDetected()
            ? TradeText.rootPercent(bias.squared())
            : "< " + TradeText.rootPercent(bias.high()));
  }

  /** Returns the table cell of the reference: its samples and noise. */
  public String referenceCell() {
    return String.format(Locale.ROOT, "%.0f: ", reference.meanSamples())
        + TradeText.rootPercent(referenceNoise);
  }
}
