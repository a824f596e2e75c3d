package io.github.lumbre.render;

import java.util.Optional;

/** Gives all pixels the same number of samples, in the passes of {@link Passes}. */
final class EvenSchedule implements Schedule {
  private final int goal;

  /**
   * Creates a schedule.
   *
   * @param goal samples per pixel
   */
  EvenSchedule(int goal) {
    this.goal = goal;
  }

  @Override
  public Optional<SampleTarget> next(Film film) {
    int done = film.fewestSamples();
    if (done >= goal) {
      return Optional.empty();
    }
    int end = Passes.next(done, goal);
    return Optional.of((x, y) -> end);
  }
}
