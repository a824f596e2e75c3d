package io.github.lumbre.render;

import java.util.OptionalDouble;

/**
 * Adds passes of samples to films, in this process ({@link FilmRenderer}) or on other machines. The
 * same samples have the same bits everywhere.
 */
public interface PassRenderer {
  /** Returns the schedule of the passes over one film. */
  Schedule schedule();

  /**
   * Adds samples until each pixel has its target.
   *
   * @param film of the render's window; no other thread may use it meanwhile
   * @param progress receives the number of samples added, and cancels the pass
   * @return whether the pass is complete, and its statistics; if it is not, some pixels have fewer
   *     samples, and another call with the same target completes it
   * @throws InterruptedException if the calling thread is interrupted; the film then holds what was
   *     added
   * @throws RenderException if the pass failed
   */
  PassResult addSamples(Film film, SampleTarget target, Progress progress)
      throws InterruptedException;

  /**
   * Returns the expected time of a pass that is always completed, in seconds, so that a caller with
   * little time left does not start it; empty if a pass can be cancelled at any time.
   */
  default OptionalDouble seconds(Film film, SampleTarget target) {
    return OptionalDouble.empty();
  }
}
