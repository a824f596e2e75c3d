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
 * Renders until a budget is used up, and estimates the noise of the picture. Immutable.
 *
 * <p>With a target error, a {@link BudgetWatch} looks at the film between passes. A frame of fewer
 * than 64 pixels has no bound of its noise: without a number of samples, its render ends after
 * {@value BudgetWatch#MOST_WITHOUT_BOUND} per pixel.
 */
public final class BudgetRenderer {
  private final FilmRenderer renderer;
  private final Budget budget;

  public BudgetRenderer(FilmRenderer renderer, Budget budget) {
    this.renderer = Objects.requireNonNull(renderer, "renderer");
    this.budget = Objects.requireNonNull(budget, "budget");
  }

  /**
   * Renders into a film, from what it has.
   *
   * @param film without samples, or one whose last pass by the same budget was completed
   * @param progress hears of samples and buckets, not of the start
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
