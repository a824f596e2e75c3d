package io.github.lumbre.base.limit.internal;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.nio.channels.ClosedByInterruptException;
import java.util.concurrent.CancellationException;

/** Stops the reading of a file when its thread is interrupted; checks at coarse intervals. */
public final class Interrupts {
  private Interrupts() {}

  /**
   * Checks whether the current thread is interrupted. The interrupt status stays unchanged.
   *
   * @throws CancellationException if the thread is interrupted
   */
  public static void check() {
    if (Thread.currentThread().isInterrupted()) {
      throw new CancellationException("reading was interrupted");
    }
  }

  /** Returns the exception for a file whose reading was interrupted. */
  public static CancellationException cancelled(ClosedByInterruptException e) {
    CancellationException cancelled = new CancellationException("reading was interrupted");
    cancelled.initCause(e);
    return cancelled;
  }

  /** Returns a stream over bytes that calls {@link #check} before it reads a block. */
  public static InputStream over(byte[] bytes, int offset, int length) {
    return new ByteArrayInputStream(bytes, offset, length) {
      @Override
      public synchronized int read(byte[] target, int to, int count) {
        check();
        return super.read(target, to, count);
      }
    };
  }
}
