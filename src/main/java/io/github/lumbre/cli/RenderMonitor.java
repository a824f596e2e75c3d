package io.github.lumbre.cli;

import io.github.lumbre.render.Bucket;
import io.github.lumbre.render.Progress;
import java.io.PrintWriter;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.LongFunction;
import java.util.function.Supplier;

/**
 * Passes on what a render has done to a display, and to the render whether the program is to end or
 * a time has passed.
 */
final class RenderMonitor implements Progress, AutoCloseable {
  private final Interruption interruption;
  private final LongFunction<ProgressDisplay> displayOf;
  private final Deadline deadline;
  private final Messages messages;
  private final AtomicReference<ProgressDisplay> display =
      new AtomicReference<>(ProgressDisplay.NONE);

  /**
   * @param hasDisplay whether to show a progress bar on standard error
   */
  RenderMonitor(Interruption interruption, boolean hasDisplay) {
    this(
        interruption,
        hasDisplay ? ProgressDisplay::bar : totalSamples -> ProgressDisplay.NONE,
        Deadline.NEVER,
        new Messages(new PrintWriter(System.err, true)));
  }

  /**
   * @param displayOf returns what shows the progress of so many samples
   * @param deadline after which the render is to stop
   * @param messages where to say that a render has stalled
   */
  RenderMonitor(
      Interruption interruption,
      LongFunction<ProgressDisplay> displayOf,
      Deadline deadline,
      Messages messages) {
    this.messages = messages;
    this.interruption = interruption;
    this.displayOf = displayOf;
    this.deadline = deadline;
  }

  @Override
  public void started(long totalSamples) {
    display.set(displayOf.apply(totalSamples));
  }

  @Override
  public void advanced(long samples) {
    display.get().advanced(samples);
  }

  /** The picture's error, relative to the picture, can be estimated now, which takes a moment. */
  void estimable(Supplier<OptionalDouble> relativeError) {
    display.get().estimable(relativeError);
  }

  @Override
  public void stalled(Bucket bucket, double seconds) {
    messages.line(
        String.format(
            Locale.ROOT,
            "warning: no sample of the bucket at %d,%d of %dx%d pixels has ended for %.0f s",
            bucket.x(),
            bucket.y(),
            bucket.width(),
            bucket.height(),
            seconds));
  }

  @Override
  public boolean isCancelled() {
    return interruption.isRequested() || deadline.hasPassed();
  }

  /** Tells whether the time for the render has passed. */
  boolean isOutOfTime() {
    return deadline.hasPassed();
  }

  @Override
  public void close() {
    display.getAndSet(ProgressDisplay.NONE).close();
  }
}
