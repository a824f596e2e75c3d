package io.github.lumbre.cli;

import io.github.lumbre.render.Progress;
import java.util.concurrent.atomic.AtomicReference;

/**
 * Passes on what a render has done to a display, and to the render whether the program is to end or
 * a time has passed.
 */
final class RenderMonitor implements Progress, AutoCloseable {
  private final Interruption interruption;
  private final boolean hasDisplay;
  private final Deadline deadline;
  private final AtomicReference<ProgressDisplay> display =
      new AtomicReference<>(ProgressDisplay.NONE);

  /**
   * @param hasDisplay whether to show a progress bar on standard error
   */
  RenderMonitor(Interruption interruption, boolean hasDisplay) {
    this(interruption, hasDisplay, Deadline.NEVER);
  }

  /**
   * @param hasDisplay whether to show a progress bar on standard error
   * @param deadline after which the render is to stop
   */
  RenderMonitor(Interruption interruption, boolean hasDisplay, Deadline deadline) {
    this.interruption = interruption;
    this.hasDisplay = hasDisplay;
    this.deadline = deadline;
  }

  @Override
  public void started(long totalSamples) {
    if (hasDisplay) {
      display.set(ProgressDisplay.bar(totalSamples));
    }
  }

  @Override
  public void advanced(long samples) {
    display.get().advanced(samples);
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
