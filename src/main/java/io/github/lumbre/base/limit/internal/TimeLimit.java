package io.github.lumbre.base.limit.internal;

import io.github.lumbre.base.limit.Limits;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

/**
 * Interrupts the thread that created it when a time has passed, until it is closed. It uses the
 * timer of the JDK, and starts no thread of its own. Safe for use by several threads.
 */
public final class TimeLimit implements AutoCloseable {
  private final Thread owner = Thread.currentThread();
  private final CompletableFuture<Void> timer = new CompletableFuture<>();
  private boolean passed;
  private boolean closed;

  private TimeLimit() {}

  /**
   * Starts the time.
   *
   * @param time at most {@link Limits#NO_TIME_LIMIT}, which needs no timer
   */
  public static TimeLimit start(Duration time) {
    TimeLimit limit = new TimeLimit();
    if (time.compareTo(Limits.NO_TIME_LIMIT) < 0) {
      limit.timer.thenRun(limit::pass);
      limit.timer.completeOnTimeout(null, time.toNanos(), TimeUnit.NANOSECONDS);
    }
    return limit;
  }

  private synchronized void pass() {
    if (!closed) {
      passed = true;
      owner.interrupt();
    }
  }

  public synchronized boolean hasPassed() {
    return passed;
  }

  /**
   * Stops the timer. If the time has passed, the interrupt status of the thread is cleared. Call it
   * in the thread that created this.
   */
  @Override
  public void close() {
    timer.cancel(false);
    synchronized (this) {
      closed = true;
      if (passed) {
        Thread.interrupted();
      }
    }
  }
}
