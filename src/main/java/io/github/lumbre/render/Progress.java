package io.github.lumbre.render;

import io.github.lumbre.scene.RenderSettings.Crop;
import java.util.Objects;
import java.util.function.BooleanSupplier;

/**
 * A listener that receives the progress of a render and can cancel it. Several threads call its
 * methods, possibly at once; they should return quickly.
 */
public interface Progress {
  /** A listener that ignores all events and never cancels. */
  Progress NONE = new Progress() {};

  /** Reports the start of a render and its total number of samples over all pixels. */
  default void started(long totalSamples) {}

  /**
   * Reports the number of samples since the last report of a thread. Called many times per second.
   */
  default void advanced(long samples) {}

  /**
   * Reports that no sample of a bucket has ended for the given number of seconds. Called after 60
   * s, 120 s, 240 s and so on.
   */
  default void stalled(Crop bucket, double seconds) {}

  /** Reports that all pixels of a bucket have the samples of a pass. */
  default void finished(Crop bucket) {}

  /**
   * Returns whether to cancel. Called every few samples; if true, the render stops and returns its
   * current picture.
   */
  default boolean isCancelled() {
    return false;
  }

  /**
   * Returns a listener that forwards all events to this one, and cancels if this one does or if the
   * condition holds.
   */
  default Progress cancelledAlsoIf(BooleanSupplier condition) {
    return new CancellingProgress(this, Objects.requireNonNull(condition, "condition"));
  }
}
