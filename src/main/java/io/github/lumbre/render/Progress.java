package io.github.lumbre.render;

import java.util.Objects;
import java.util.function.BooleanSupplier;

/**
 * Hears what a render has done and may cancel it. All methods are called from several threads, any
 * of them at once, and should return quickly.
 */
public interface Progress {
  /** Hears nothing and never cancels. */
  Progress NONE = new Progress() {};

  /** The render begins: so many samples over all pixels. */
  default void started(long totalSamples) {}

  /** So many more samples are done: a fraction of a bucket, many times a second. */
  default void advanced(long samples) {}

  /** For so many seconds, no sample of a bucket has ended: told after a minute, two, four, …. */
  default void stalled(Bucket bucket, double seconds) {}

  /** All pixels of a bucket have what a pass gives them. */
  default void finished(Bucket bucket) {}

  /** Asked every few samples: true makes the render stop and return what it has. */
  default boolean isCancelled() {
    return false;
  }

  /** Returns a listener that hears what this one does, and cancels if this one does or if asked. */
  default Progress cancelledAlsoIf(BooleanSupplier condition) {
    return new CancellingProgress(this, Objects.requireNonNull(condition, "condition"));
  }
}
