package io.github.lumbre.render;

import io.github.lumbre.render.internal.Passes;
import java.util.Optional;
import java.util.function.IntBinaryOperator;

/**
 * Decides, between the passes over a film, how many samples the next pass adds. Mutable; one
 * instance per film.
 */
public interface Schedule {
  /**
   * Returns the target of the next pass; empty if the film is complete. The result stays the same
   * until the film has reached the target, for example after a cancelled pass.
   */
  Optional<SampleTarget> next(Film film);

  /**
   * Returns a schedule that gives all pixels the same number of samples.
   *
   * @param goal samples per pixel at the end
   * @param passes returns the samples per pixel after a pass, from those before it and the goal;
   *     such as {@link Passes#next}
   */
  static Schedule even(int goal, IntBinaryOperator passes) {
    return film -> {
      int done = film.fewestSamples();
      if (done >= goal) {
        return Optional.empty();
      }
      int end = passes.applyAsInt(done, goal);
      return Optional.of((x, y) -> end);
    };
  }
}
