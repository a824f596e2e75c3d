package io.github.lumbre.render;

/**
 * Receives the film of a render between passes, and pauses long passes to receive it sooner. The
 * samples of the film do not depend on it.
 */
public interface PassListener {
  /** The listener that pauses no pass. */
  PassListener NONE = new PassListener() {};

  /**
   * Returns whether to pause the current pass and call {@link #passed}. Several threads call this,
   * many times per second.
   */
  default boolean isDue() {
    return false;
  }

  /**
   * Receives a film after a pass or within a paused one. The render waits until this method
   * returns.
   *
   * @param soFar whether the pass is complete, and the statistics of all samples that this run of
   *     the {@link PassLoop} has added
   */
  default void passed(Film film, PassResult soFar) {}
}
