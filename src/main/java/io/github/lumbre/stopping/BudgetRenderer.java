package io.github.lumbre.stopping;

import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassResult;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.SampleTarget;
import io.github.lumbre.render.Schedule;
import java.util.Objects;
import java.util.Optional;

/**
 * Renders until a limit of the budget is reached, and estimates the noise of the picture.
 * Immutable.
 *
 * <p>With a target error, a {@link BudgetWatch} checks the film between passes. Frames of fewer
 * than 64 pixels have no error bound. Without a limit on samples, their renders end after {@value
 * BudgetWatch#MOST_WITHOUT_BOUND} samples per pixel.
 */
public final class BudgetRenderer {
  private final FilmRenderer renderer;
  private final Budget budget;

  public BudgetRenderer(FilmRenderer renderer, Budget budget) {
    this.renderer = Objects.requireNonNull(renderer, "renderer");
    this.budget = Objects.requireNonNull(budget, "budget");
  }

  /**
   * Adds samples to a film until a limit of the budget is reached or the render is cancelled.
   *
   * @param film a film without samples, or one whose last pass by the same budget was completed
   * @param progress receives samples and buckets, but not the start
   * @throws InterruptedException if the calling thread is interrupted
   */
  public BudgetResult render(Film film, Progress progress) throws InterruptedException {
    RenderStatistics statistics = RenderStatistics.ZERO;
    BudgetWatch watch = new BudgetWatch(budget);
    boolean complete = true;
    Schedule schedule = renderer.schedule(budget.samples());
    for (Optional<SampleTarget> target = schedule.next(film);
        complete && target.isPresent();
        target = schedule.next(film)) {
      PassResult pass = renderer.addSamples(film, target.get(), progress);
      statistics = statistics.plus(pass.statistics());
      complete = pass.complete();
      if (complete && (watch.isReachedBy(film) || watch.isHopeless(film))) {
        break;
      }
    }
    Optional<NoiseEstimate> noise = watch.estimate(film);
    boolean reached = noise.filter(budget::isReachedBy).isPresent();
    return new BudgetResult(complete, reached, noise, statistics);
  }
}
