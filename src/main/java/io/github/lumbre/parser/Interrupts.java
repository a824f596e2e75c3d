package io.github.lumbre.parser;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.util.concurrent.CancellationException;

/** Stops the reading of a scene when its thread is interrupted; checks at coarse intervals. */
final class Interrupts {
  private Interrupts() {}

  /**
   * Checks whether the current thread is interrupted. The interrupt status stays unchanged.
   *
   * @throws CancellationException if the thread is interrupted
   */
  static void check() {
    if (Thread.currentThread().isInterrupted()) {
      throw new CancellationException("reading the scene was interrupted");
    }
  }

  /** Returns a stream over bytes that calls {@link #check} before it reads a block. */
  static InputStream over(byte[] bytes) {
    return new ByteArrayInputStream(bytes) {
      @Override
      public synchronized int read(byte[] target, int offset, int length) {
        check();
        return super.read(target, offset, length);
      }
    };
  }
}
