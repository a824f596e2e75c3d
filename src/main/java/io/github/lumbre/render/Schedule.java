package io.github.lumbre.render;

import java.util.Optional;

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
}
