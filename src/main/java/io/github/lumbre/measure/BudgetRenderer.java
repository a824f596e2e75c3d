package io.github.lumbre.measure;

import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassResult;
import io.github.lumbre.render.Passes;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderStatistics;
import java.util.Objects;
import java.util.Optional;

/**
 * Renders until a budget is used up, and tells how noisy the picture is then. Immutable.
 *
 * <p>With a target error it looks at the film after 32 samples per pixel, 48, 64, 96, ... (see
 * {@link Looks}), which are as many as the scene's noise, and nothing else, says: the same seed
 * stops at the same number of samples on every machine.
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
   * @param film whose pixels have as many samples each, or none
   * @param progress hears of samples and buckets, not of the start
   * @throws InterruptedException if the calling thread is interrupted
   */
  public BudgetResult render(Film film, Progress progress) throws InterruptedException {
    RenderStatistics statistics = RenderStatistics.ZERO;
    int looks = 0;
    boolean complete = true;
    for (int done = film.fewestSamples(); complete && done < budget.samples(); ) {
      done = Passes.next(done, budget.samples());
      PassResult pass = renderer.addSamples(film, done, progress);
      statistics = statistics.plus(pass.statistics());
      complete = pass.complete();
      if (complete && budget.targetError().isPresent() && Looks.isDueAfter(done)) {
        looks++;
        Optional<NoiseEstimate> noise = noise(film, looks);
        if (noise.filter(budget::isReachedBy).isPresent()) {
          return new BudgetResult(true, true, noise, statistics);
        }
      }
    }
    Optional<NoiseEstimate> noise = noise(film, looks + 1);
    boolean reached = noise.filter(budget::isReachedBy).isPresent();
    return new BudgetResult(complete, reached, noise, statistics);
  }

  /** Looks at the noise; without a target there is one look. */
  private Optional<NoiseEstimate> noise(Film film, int look) {
    double confidence =
        budget.targetError().isPresent()
            ? Looks.confidence(budget.confidence(), look)
            : budget.confidence();
    return NoiseEstimator.of(film, confidence)
        .map(
            estimate ->
                new NoiseEstimate(
                    estimate.relativeMse(),
                    estimate.upperRelativeMse(),
                    budget.confidence(),
                    estimate.tailShare(),
                    estimate.pixels()));
  }
}
