package io.github.lumbre.measure;

import io.github.lumbre.render.Film;
import io.github.lumbre.render.Passes;
import java.util.Optional;

/**
 * Looks at a film between passes and tells whether the error is reached that was asked for.
 * Mutable, for one render.
 *
 * <p>It looks after 32 samples per pixel, 48, 64, 96, ... (see {@link Looks}), which depend on
 * nothing but the scene: the same seed stops at the same number of samples on every machine.
 */
public final class BudgetWatch {
  private final Budget budget;
  private int looks;
  private int lastDue;
  private long samplesAtLook;
  private Optional<Forecast> forecast = Optional.empty();

  public BudgetWatch(Budget budget) {
    this.budget = budget;
  }

  /**
   * Goes on where another render of the film ended: counts the looks that come before, and looks if
   * the film has just had a pass.
   *
   * @return whether the film has reached the error
   */
  public boolean isReachedAgainBy(Film film) {
    int fewest = film.fewestSamples();
    for (int end = Passes.next(0, fewest); end < fewest; end = Passes.next(end, fewest)) {
      int due = Looks.due(end);
      looks += due == lastDue ? 0 : 1;
      lastDue = due;
    }
    return fewest == film.mostSamples() && isReachedBy(film);
  }

  /**
   * Tells whether the film has reached the error; false between looks.
   *
   * @param film after a complete pass: others end where the machine was slow, which the picture
   *     must not depend on
   */
  public boolean isReachedBy(Film film) {
    double samples = film.meanSamples();
    int due = Looks.due(samples);
    if (budget.targetError().isEmpty() || due == lastDue) {
      return false;
    }
    lastDue = due;
    samplesAtLook = film.totalSamples();
    looks++;
    Optional<NoiseEstimate> noise = estimate(film, looks);
    double target = budget.targetError().getAsDouble();
    forecast =
        noise
            .filter(n -> Double.isFinite(n.upperRelativeMse()))
            .map(n -> Forecast.of(n, samples, target));
    return noise.filter(budget::isReachedBy).isPresent();
  }

  /** Returns how many samples the error will take, by the last look; empty before there is one. */
  public Optional<Forecast> forecast() {
    return forecast;
  }

  /**
   * Returns the noise of the film as it is when the render has ended; empty if some pixel has fewer
   * than two samples or came from a file that does not tell.
   */
  public Optional<NoiseEstimate> estimate(Film film) {
    boolean isSeen = looks > 0 && samplesAtLook == film.totalSamples();
    return estimate(film, isSeen ? looks : looks + 1);
  }

  /** Looks at the noise; without a target there is one look. */
  private Optional<NoiseEstimate> estimate(Film film, int look) {
    double confidence =
        budget.targetError().isPresent()
            ? Looks.confidence(budget.confidence(), look)
            : budget.confidence();
    return NoiseEstimator.of(film, confidence).map(noise -> noise.claiming(budget.confidence()));
  }
}
