package io.github.lumbre.cli.run;

import io.github.lumbre.cli.output.NoiseReport;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.stopping.Budget;
import io.github.lumbre.render.stopping.BudgetWatch;
import io.github.lumbre.render.stopping.NoiseEstimate;
import io.github.lumbre.scene.RenderSettings;
import java.time.Duration;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The limits of a run: samples, a time or a target error; the first that is reached ends it.
 * Mutable, for one run.
 */
public final class RunBudget {
  /** The time to start the JVM and to write the file. */
  private static final Duration AROUND = Duration.ofMillis(400);

  /** The largest time per megapixel to develop, analyze and encode a picture, on a slow machine. */
  private static final Duration PER_MEGAPIXEL = Duration.ofMillis(1000);

  /** The estimates at the end take at most 1/50 of the whole time. */
  private static final int WHOLE_OVER_ESTIMATES = 50;

  private final Budget budget;
  private final BudgetWatch watch;
  private final Deadline time;

  /**
   * @param time deadline after which no more samples are taken
   */
  public RunBudget(Budget budget, Deadline time) {
    this.budget = budget;
    this.time = time;
    watch = new BudgetWatch(budget, time::secondsLeft);
  }

  /**
   * Returns the rendering time of a command with a time limit. It is the time left after starting,
   * developing, estimating the energy lost to the path length limit, and writing, but at least half
   * of the limit.
   *
   * @param startup start time of the JVM; a busy machine also takes longer at the end
   */
  public static Duration rendering(Duration whole, Duration startup, RenderSettings settings) {
    long pixels = settings.window().pixels();
    Duration slow = startup.dividedBy(2);
    Duration end = AROUND.compareTo(slow) > 0 ? AROUND : slow;
    Duration rest =
        end.plus(PER_MEGAPIXEL.multipliedBy(pixels).dividedBy(1_000_000))
            .plus(whole.dividedBy(WHOLE_OVER_ESTIMATES));
    Duration left = whole.minus(rest);
    Duration half = whole.dividedBy(2);
    return left.compareTo(half) > 0 ? left : half;
  }

  /** Returns the target error; empty if there is none. */
  OptionalDouble targetError() {
    return budget.targetError();
  }

  /** Returns the confidence level of the target error. */
  double confidence() {
    return budget.confidence();
  }

  /** Returns whether only a time or a target error limits the samples. */
  boolean isOpen() {
    return budget.samples() == RenderSettings.MAX_SAMPLES;
  }

  /** Returns the rule that ends the run at its time or target error. */
  BudgetWatch watch() {
    return watch;
  }

  /**
   * Returns the warning that the frame is too small for a noise bound, so that the target error
   * cannot end the run; empty if it is large enough.
   */
  Optional<String> doubt(Film film) {
    if (!watch.isWithoutBound(film)) {
      return Optional.empty();
    }
    String end =
        isOpen() && secondsLeft().isEmpty()
            ? "the render ends after " + BudgetWatch.MOST_WITHOUT_BOUND + " samples per pixel"
            : "--samples or --time ends the render";
    return Optional.of(
        "warning: --target-error: frames of fewer than 64 pixels have no noise bound; " + end);
  }

  /** Returns whether the deadline has passed. */
  boolean isOutOfTime() {
    return time.hasPassed();
  }

  /** Returns whether the time or the target error ends the run. */
  boolean isOver() {
    return watch.isMet() || isOutOfTime();
  }

  /** Returns the seconds until the deadline; empty if there is none. */
  OptionalDouble secondsLeft() {
    return time.secondsLeft();
  }

  /** Returns an estimate of the film's relative error; empty while it is unknown. */
  OptionalDouble noise(Film film) {
    return watch.estimate(film).stream().mapToDouble(NoiseEstimate::relativeRmse).findAny();
  }

  NoiseReport report(Film film) {
    Optional<NoiseEstimate> noise = watch.estimate(film);
    boolean reachedTarget = noise.filter(budget::isReachedBy).isPresent();
    String end = reachedTarget ? "error" : time.hasPassed() ? "time" : "samples";
    return new NoiseReport(film, noise, budget.targetError(), reachedTarget, end);
  }
}
