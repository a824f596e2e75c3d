package io.github.lumbre.stopping;

import io.github.lumbre.render.Film;
import io.github.lumbre.render.Passes;
import io.github.lumbre.scene.RenderSettings;
import java.util.Optional;

/**
 * Checks between passes whether a film has reached the target error. Mutable, for one render.
 *
 * <p>It checks the error after 32 samples per pixel, 48, 64, 96, ..., and in frames of enough
 * pixels after 4, 8 and 16 too (see {@link StoppingSchedule}). This depends on nothing but the
 * scene: the same seed stops at the same number of samples on every machine.
 */
public final class BudgetWatch {
  /**
   * Samples per pixel that end a render to a target error in a frame of fewer than 64 pixels, whose
   * noise has no bound, if no number of samples ends it.
   */
  public static final int MOST_WITHOUT_BOUND = 4096;

  private final Budget budget;

  /** Checks so far, the early ones left out. */
  private int looks;

  private int lastDue;
  private long samplesAtLook;
  private Optional<Forecast> forecast = Optional.empty();

  public BudgetWatch(Budget budget) {
    this.budget = budget;
  }

  /**
   * Resumes where another render of the film ended: counts the earlier checks, and checks if the
   * film has just had a pass.
   *
   * @return whether the film has reached the error
   */
  public boolean isReachedAgainBy(Film film) {
    int fewest = film.fewestSamples();
    for (int end = Passes.next(0, fewest); end < fewest; end = Passes.next(end, fewest)) {
      int due = StoppingSchedule.due(end);
      looks += due == lastDue || StoppingSchedule.isEarly(end) ? 0 : 1;
      lastDue = due;
    }
    return fewest == film.mostSamples() && isReachedBy(film);
  }

  /**
   * Returns whether the film has reached the error; false between checks.
   *
   * @param film after a complete pass: others end where the machine was slow, which the picture
   *     must not depend on
   */
  public boolean isReachedBy(Film film) {
    double samples = film.meanSamples();
    int due = StoppingSchedule.due(samples);
    if (budget.targetError().isEmpty() || due == lastDue) {
      return false;
    }
    lastDue = due;
    double target = budget.targetError().getAsDouble();
    if (!StoppingSchedule.isEarlyEnough(samples, pixels(film), target)) {
      return false;
    }
    samplesAtLook = film.totalSamples();
    looks += StoppingSchedule.isEarly(samples) ? 0 : 1;
    Optional<NoiseEstimate> noise = estimate(film, looks);
    if (StoppingSchedule.isEarly(samples)) {
      return noise.filter(n -> budget.isReachedBy(n) && !n.hasHeavyTail()).isPresent();
    }
    forecast =
        noise
            .filter(n -> Double.isFinite(n.upperRelativeMse()))
            .map(n -> Forecast.of(n, samples, target));
    return noise.filter(budget::isReachedBy).isPresent();
  }

  /**
   * Returns the next number of samples per pixel after which a render in the passes of {@link
   * Passes} checks its error, or the goal if no check comes before.
   *
   * @param done samples per pixel so far
   * @param goal samples per pixel at the end, more than {@code done}
   */
  public static int nextCheck(int done, int goal) {
    int end = Passes.next(done, goal);
    while (end < goal && StoppingSchedule.due(end) == StoppingSchedule.due(done)) {
      end = Passes.next(end, goal);
    }
    return end;
  }

  /**
   * Returns whether the film's frame is too small for a bound of its noise, so that no number of
   * samples reaches the target error.
   */
  public boolean isWithoutBound(Film film) {
    return budget.targetError().isPresent() && pixels(film) < NoiseEstimator.FEWEST_PIXELS;
  }

  /**
   * Returns whether the film has {@value #MOST_WITHOUT_BOUND} samples per pixel and its frame is
   * too small for a bound, and the budget has no number of samples.
   */
  public boolean isHopeless(Film film) {
    return isWithoutBound(film)
        && budget.samples() == RenderSettings.MAX_SAMPLES
        && film.meanSamples() >= MOST_WITHOUT_BOUND;
  }

  private static double pixels(Film film) {
    return (double) film.window().width() * film.window().height();
  }

  /** Returns how many samples the error will take, by the last look; empty before there is one. */
  public Optional<Forecast> forecast() {
    return forecast;
  }

  /**
   * Returns the noise of the film as it is when the render has ended; empty if some pixel has fewer
   * than two samples or came from a file without halves.
   */
  public Optional<NoiseEstimate> estimate(Film film) {
    boolean isSeen = samplesAtLook != 0 && samplesAtLook == film.totalSamples();
    return estimate(film, isSeen ? looks : looks + 1);
  }

  /** Estimates the noise; without a target this is the only check. */
  private Optional<NoiseEstimate> estimate(Film film, int look) {
    boolean isEarly = StoppingSchedule.isEarly(film.meanSamples());
    double confidence = budget.confidence();
    if (budget.targetError().isPresent()) {
      confidence =
          isEarly
              ? StoppingSchedule.earlyConfidence(confidence)
              : StoppingSchedule.confidence(confidence, look);
    }
    Optional<NoiseEstimate> noise =
        isEarly
            ? NoiseEstimator.ofFewSamples(film, confidence)
            : NoiseEstimator.of(film, confidence);
    return noise.map(n -> n.claiming(budget.confidence()));
  }
}
