package io.github.lumbre.render;

import java.util.Optional;

/** Decides, between the passes over a film, what the next one gives it. Mutable, for one film. */
public interface Schedule {
  /**
   * Returns what each pixel is to have after the next pass, or empty if there is none to come.
   * Until the film has that, as after a pass that was cancelled, the answer stays the same.
   */
  Optional<SampleTarget> next(Film film);
}
