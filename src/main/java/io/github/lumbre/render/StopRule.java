package io.github.lumbre.render;

import java.util.OptionalDouble;

/**
 * Ends a render before it has all its samples. A render completes its first pass in any case, so
 * that every pixel has a sample.
 */
public interface StopRule {
  /** The rule that ends no render. */
  StopRule NONE = new StopRule() {};

  /** Examines a film after a complete pass. */
  default void passed(Film film) {}

  /** Returns whether the render ends here. The thread that starts the passes calls this. */
  default boolean isMet() {
    return false;
  }

  /**
   * Returns the time that is left, in seconds; empty without a time limit. When no time is left,
   * passes are cut short. Several threads call this, many times per second.
   */
  default OptionalDouble secondsLeft() {
    return OptionalDouble.empty();
  }
}
