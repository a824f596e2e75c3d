package io.github.lumbre.lab.trade;

import io.github.lumbre.image.Image;
import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.lab.metrics.PictureError;
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
 * Measures how wrong pictures are that end at an error of their own estimate and at a depth, with
 * several seeds each, against a reference of great depth.
 */
public final class QualityStudy {
  /** Differs from all seeds of the study. */
  private static final long REFERENCE_SEED = -1;

  /** Roulette ends paths long before. */
  private static final int DEEP = 1000;

  private static final int FEWEST_SAMPLES = 64;

  private final Scene scene;
  private final RenderSettings settings;
  private final double end;
  private final Image truth;
  private final Film reference;
  private final double referenceNoise;

  /**
   * What one quality gave.
   *
   * @param samples per pixel, mean over the seeds
   * @param error relative mean squared error, the reference's own taken off
   * @param largest error of all seeds, likewise
   * @param bias that samples would not take away
   */
  public record Row(Interval samples, Interval error, double largest, TradeRow.Bias bias) {}

  /**
   * Renders the reference.
   *
   * @param settings for path tracing
   * @param relativeMse that the reference is to have at most
   * @param seconds for everything, of which the reference takes half at most
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
    // Whatever the time, lest there is nothing to compare with.
    TradeClimb.climb(renderer, reference, FEWEST_SAMPLES);
    render(renderer, reference, Math.sqrt(relativeMse), start + seconds / 2);
    truth = reference.develop();
    referenceNoise = NoiseEstimate.of(reference, Budget.CONFIDENCE).orElseThrow().relativeMse();
  }

  private FilmRenderer renderer(int depth, long seed) {
    return new FilmRenderer(
        settings.toBuilder().maxTraceDepth(depth).adaptive(false).seed(seed).build(), scene);
  }

  /** Renders until an error, or a moment; returns whether the error was reached. */
  private static boolean render(FilmRenderer renderer, Film film, double error, double deadline)
      throws InterruptedException {
    Budget budget =
        new Budget(RenderSettings.MAX_SAMPLES, OptionalDouble.of(error), Budget.CONFIDENCE);
    Progress until = Progress.NONE.cancelledAlsoIf(() -> TradeClimb.clock() > deadline);
    return new BudgetRenderer(renderer, budget).render(film, until).reachedTarget();
  }

  /**
   * Renders with an error and a depth.
   *
   * @param error relative root mean squared error at which each render ends
   * @param seeds at least 3
   * @return empty if there is no time for that
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

  /** Returns the cells of a table that tell a row: samples, error, its largest, bias. */
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

  /** Returns the cells that tell the reference: its samples and noise. */
  public String referenceCell() {
    return String.format(Locale.ROOT, "%.0f: ", reference.meanSamples())
        + TradeText.rootPercent(referenceNoise);
  }
}
