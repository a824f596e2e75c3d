package io.github.lumbre.cli.run;

import io.github.lumbre.cli.output.NoiseReport;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.Progress;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.stopping.Budget;
import io.github.lumbre.stopping.BudgetWatch;
import io.github.lumbre.stopping.Forecast;
import io.github.lumbre.stopping.NoiseEstimate;
import java.time.Duration;
import java.util.Optional;
import java.util.OptionalDouble;

/** What ends a run: samples, a time or an error, whichever comes first. Mutable, for one run. */
public final class RunBudget {
  /** What the virtual machine takes to start and the file to appear. */
  private static final Duration AROUND = Duration.ofMillis(400);

  /** What developing, judging and encoding a pixel takes at most, on a slow machine. */
  private static final Duration PER_MEGAPIXEL = Duration.ofMillis(1000);

  /** The time of estimates at the end is at most the whole over this. */
  private static final int WHOLE_OVER_ESTIMATES = 50;

  private final Budget budget;
  private final BudgetWatch watch;
  private final Deadline time;
  private boolean reachedTarget;
  private boolean hopeless;

  /**
   * @param time after which no more samples are taken
   */
  public RunBudget(Budget budget, Deadline time) {
    this.budget = budget;
    this.time = time;
    watch = new BudgetWatch(budget);
  }

  /**
   * Returns the time for rendering when the whole command is to take a time: what is left after
   * starting, developing, estimating what the depth cuts off, and writing, but half of it at least.
   *
   * @param startup what the virtual machine took to start: a busy machine takes longer for the end
   *     too
   */
  public static Duration rendering(Duration whole, Duration startup, RenderSettings settings) {
    long pixels = (long) settings.window().width() * settings.window().height();
    Duration slow = startup.dividedBy(2);
    Duration end = AROUND.compareTo(slow) > 0 ? AROUND : slow;
    Duration rest =
        end.plus(PER_MEGAPIXEL.multipliedBy(pixels).dividedBy(1_000_000))
            .plus(whole.dividedBy(WHOLE_OVER_ESTIMATES));
    Duration left = whole.minus(rest);
    Duration half = whole.dividedBy(2);
    return left.compareTo(half) > 0 ? left : half;
  }

  /** Returns the error to be reached; empty if none is. */
  OptionalDouble targetError() {
    return budget.targetError();
  }

  /** Returns how sure that is to be. */
  double confidence() {
    return budget.confidence();
  }

  /** Tells whether nothing but a time or an error limits the samples. */
  boolean isOpen() {
    return budget.samples() == RenderSettings.MAX_SAMPLES;
  }

  /** Returns how many samples the error will take; empty as long as that cannot be told. */
  Optional<Forecast> forecast() {
    return watch.forecast();
  }

  /** Looks at the error of a film that another run has begun. */
  void lookAgain(Film film) {
    reachedTarget |= watch.isReachedAgainBy(film);
    hopeless = !hasTime() && watch.isHopeless(film);
  }

  /** Looks at the error of a film after a complete pass. */
  void look(Film film) {
    reachedTarget |= watch.isReachedBy(film);
    hopeless = !hasTime() && watch.isHopeless(film);
  }

  private boolean hasTime() {
    return time.secondsLeft().isPresent();
  }

  /**
   * Returns the warning that the frame is too small for a bound of the noise, so that something
   * other than the error will end the run; empty if it is large enough.
   */
  Optional<String> doubt(Film film) {
    if (!watch.isWithoutBound(film)) {
      return Optional.empty();
    }
    String end =
        isOpen() && !hasTime()
            ? "the render ends after " + BudgetWatch.MOST_WITHOUT_BOUND + " samples per pixel"
            : "--samples or --time ends the render";
    return Optional.of(
        "warning: --target-error: a frame of fewer than 64 pixels has no bound of its noise; "
            + end);
  }

  /** Returns whether time or error end the run, or the frame has no bound and enough samples. */
  boolean isUsedUp() {
    return reachedTarget || hopeless || time.hasPassed();
  }

  /** Returns a listener that also ends passes when the time is over. */
  Progress within(Progress progress) {
    return progress.cancelledAlsoIf(time::hasPassed);
  }

  /** Tells whether the time is over. */
  boolean isOutOfTime() {
    return time.hasPassed();
  }

  /** Returns the seconds until the time ends the run; empty if there is none. */
  OptionalDouble secondsLeft() {
    return time.secondsLeft();
  }

  /** Returns about how noisy the film is now; empty as long as that cannot be told. */
  OptionalDouble noise(Film film) {
    return watch.estimate(film).stream().mapToDouble(NoiseEstimate::relativeRmse).findAny();
  }

  /** Returns what is to be told of the film when the run has ended. */
  NoiseReport report(Film film) {
    Optional<NoiseEstimate> noise = watch.estimate(film);
    reachedTarget |= noise.filter(budget::isReachedBy).isPresent();
    String end = reachedTarget ? "error" : time.hasPassed() ? "time" : "samples";
    return new NoiseReport(film, noise, budget.targetError(), reachedTarget, end);
  }
}
