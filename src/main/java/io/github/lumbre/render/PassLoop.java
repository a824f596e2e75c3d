package io.github.lumbre.render;

import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The passes over one film: renders one after the other until the film has all its samples, a
 * {@link StopRule} ends the render, or it is cancelled. A loop that was ended can be run again; it
 * then adds the missing samples. Mutable, for one thread.
 */
public final class PassLoop {
  private final PassRenderer renderer;
  private final Film film;
  private final Schedule schedule;

  /** Creates the loop over a new film or a resumed one, in the passes of the renderer. */
  public PassLoop(PassRenderer renderer, Film film) {
    this(renderer, film, renderer.schedule());
  }

  /** Creates the loop over a new film or a resumed one, in other passes than the renderer's. */
  public PassLoop(PassRenderer renderer, Film film, Schedule schedule) {
    this.renderer = Objects.requireNonNull(renderer, "renderer");
    this.film = Objects.requireNonNull(film, "film");
    this.schedule = Objects.requireNonNull(schedule, "schedule");
  }

  /**
   * Renders until the film has all its samples; see {@link #run(StopRule, PassListener, Progress)}.
   */
  public PassResult run(Progress progress) throws InterruptedException {
    return run(StopRule.NONE, PassListener.NONE, progress);
  }

  /**
   * Renders until the film has all its samples, the rule ends the render, or it is cancelled.
   *
   * @param progress receives all events except {@link Progress#started}
   * @return whether the render has ended without being cancelled, and the statistics of the samples
   *     that this run added
   * @throws InterruptedException if the calling thread is interrupted; the film holds the samples
   *     so far
   * @throws RenderException if a pass failed
   */
  public PassResult run(StopRule rule, PassListener listener, Progress progress)
      throws InterruptedException {
    RenderStatistics statistics = RenderStatistics.ZERO;
    while (!isOver(rule) && !progress.isCancelled()) {
      Optional<SampleTarget> target = schedule.next(film);
      if (target.isEmpty()) {
        break;
      }
      OptionalDouble seconds = renderer.seconds(film, target.get());
      if (isTooLong(seconds, rule)) {
        return new PassResult(true, statistics);
      }
      // A pass whose time is known is always completed.
      Progress during = seconds.isPresent() ? progress : cut(progress, rule, listener);
      PassResult pass = renderer.addSamples(film, target.get(), during);
      statistics = statistics.plus(pass.statistics());
      if (pass.complete()) {
        rule.passed(film);
      }
      listener.passed(film, new PassResult(pass.complete(), statistics));
    }
    return new PassResult(isOver(rule) || schedule.next(film).isEmpty(), statistics);
  }

  private boolean isOver(StopRule rule) {
    return (rule.isMet() || isOutOfTime(rule)) && !isFirstPass();
  }

  private boolean isTooLong(OptionalDouble seconds, StopRule rule) {
    return seconds.isPresent()
        && rule.secondsLeft().orElse(Double.POSITIVE_INFINITY) < seconds.getAsDouble()
        && !isFirstPass();
  }

  private Progress cut(Progress progress, StopRule rule, PassListener listener) {
    return isFirstPass()
        ? progress.cancelledAlsoIf(listener::isDue)
        : progress.cancelledAlsoIf(() -> listener.isDue() || isOutOfTime(rule));
  }

  private static boolean isOutOfTime(StopRule rule) {
    return rule.secondsLeft().orElse(1) <= 0;
  }

  private boolean isFirstPass() {
    return film.fewestSamples() == 0;
  }
}
