package io.github.lumbre.render.stopping;

import io.github.lumbre.render.Film;
import io.github.lumbre.render.StopRule;
import io.github.lumbre.render.internal.Passes;
import io.github.lumbre.scene.RenderSettings;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;

/**
 * Ends a render at the target error of a {@link Budget}, or at a time, and estimates the noise of
 * its picture. The budget has the samples of the render's schedule. Mutable, for one render.
 *
 * <p>The checks take place after 32, 48, 64, 96, ... samples per pixel, and in frames with enough
 * pixels also after 4, 8 and 16 (see {@link StoppingSchedule}). They depend only on the scene and
 * its settings: with the same seed, a render stops at the same number of samples on every machine.
 *
 * <p>Frames of fewer than 64 pixels have no error bound. Without a limit on samples and time, their
 * renders end after {@value #MOST_WITHOUT_BOUND} samples per pixel.
 */
public final class BudgetWatch implements StopRule {
  /**
   * The number of samples per pixel that ends a render to a target error in a frame of fewer than
   * 64 pixels, which has no error bound, if the budget does not limit the samples.
   */
  public static final int MOST_WITHOUT_BOUND = 4096;

  private final Budget budget;
  private final Supplier<OptionalDouble> secondsLeft;

  /** The number of checks so far, without the early ones. */
  private int looks;

  private int lastDue;
  private long samplesAtLook;
  private Optional<Forecast> forecast = Optional.empty();
  private boolean isMet;

  /** Creates the watch of a render without a time limit. */
  public BudgetWatch(Budget budget) {
    this(budget, OptionalDouble::empty);
  }

  /**
   * @param secondsLeft supplies the time that is left, in seconds; empty without a time limit.
   *     Several threads call it
   */
  public BudgetWatch(Budget budget, Supplier<OptionalDouble> secondsLeft) {
    this.budget = Objects.requireNonNull(budget, "budget");
    this.secondsLeft = Objects.requireNonNull(secondsLeft, "secondsLeft");
  }

  /**
   * Resumes where an earlier render of the film ended: counts the checks of that render, and checks
   * the error if the film's last pass is complete.
   */
  public void resume(Film film) {
    int fewest = film.fewestSamples();
    for (int end = passEnd(0, film); end < fewest; end = passEnd(end, film)) {
      int due = StoppingSchedule.due(end);
      looks += due == lastDue || StoppingSchedule.isEarly(end) ? 0 : 1;
      lastDue = due;
    }
    isMet = fewest == film.mostSamples() && isReachedBy(film) || isHopeless(film);
  }

  /** Returns the end of the pass after some samples per pixel, which has all poses. */
  private static int passEnd(int done, Film film) {
    int end = Passes.next(done, film.fewestSamples());
    return end + Math.floorMod(-end, film.poses());
  }

  /**
   * Checks the error of a film if a check is due.
   *
   * @param film a film after a complete pass. Where a cancelled pass ends depends on the speed of
   *     the machine, and the picture must not depend on that
   */
  @Override
  public void passed(Film film) {
    isMet |= isReachedBy(film) || isHopeless(film);
  }

  @Override
  public boolean isMet() {
    return isMet;
  }

  @Override
  public OptionalDouble secondsLeft() {
    return secondsLeft.get();
  }

  /** Returns whether a check is due and finds that the film has reached the target error. */
  private boolean isReachedBy(Film film) {
    double samples = film.meanSamples();
    int due = StoppingSchedule.due(samples);
    if (budget.targetError().isEmpty() || due == lastDue) {
      return false;
    }
    lastDue = due;
    double target = budget.targetError().getAsDouble();
    if (!StoppingSchedule.isEarlyEnough(samples, film.window().pixels(), target)) {
      return false;
    }
    samplesAtLook = film.totalSamples();
    looks += StoppingSchedule.isEarly(samples) ? 0 : 1;
    Optional<NoiseEstimate> noise = estimate(film, looks);
    if (!StoppingSchedule.isEarly(samples)) {
      forecast =
          noise
              .filter(n -> Double.isFinite(n.upperRelativeMse()))
              .map(n -> Forecast.of(n, samples, target));
    }
    return noise.filter(budget::isReachedBy).isPresent();
  }

  /**
   * Returns the number of samples per pixel at the next error check of a render in the passes of
   * {@link Passes}, at most the goal.
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
   * Returns whether there is a target error, but the film's frame is too small for an error bound,
   * so that no number of samples reaches the target.
   */
  public boolean isWithoutBound(Film film) {
    return budget.targetError().isPresent()
        && film.window().pixels() < NoiseEstimator.FEWEST_PIXELS;
  }

  /** Returns whether the render should give up, because only an unknown error could end it. */
  private boolean isHopeless(Film film) {
    return isWithoutBound(film)
        && secondsLeft().isEmpty()
        && budget.samples() == RenderSettings.MAX_SAMPLES
        && film.meanSamples() >= MOST_WITHOUT_BOUND;
  }

  /**
   * Returns the forecast of the number of samples that the target error takes, from the last check;
   * empty before the first one that is not early.
   */
  public Optional<Forecast> forecast() {
    return forecast;
  }

  /**
   * Returns the noise estimate of a film at the end of the render; empty if a pixel has fewer than
   * two samples, or if the halves of its samples are unknown.
   */
  public Optional<NoiseEstimate> estimate(Film film) {
    boolean isSeen = samplesAtLook != 0 && samplesAtLook == film.totalSamples();
    return estimate(film, isSeen ? looks : looks + 1);
  }

  /**
   * Estimates the noise. Without a target error, this is the only check and needs no correction of
   * the confidence.
   */
  private Optional<NoiseEstimate> estimate(Film film, int look) {
    double confidence = budget.confidence();
    if (budget.targetError().isPresent()) {
      confidence =
          StoppingSchedule.isEarly(film.meanSamples())
              ? StoppingSchedule.earlyConfidence(confidence)
              : StoppingSchedule.confidence(confidence, look);
    }
    return NoiseEstimator.of(film, confidence).map(n -> n.claiming(budget.confidence()));
  }
}
