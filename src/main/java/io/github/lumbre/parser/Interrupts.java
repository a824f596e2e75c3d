package io.github.lumbre.parser;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.util.concurrent.CancellationException;

/** Lets an interrupt of the reading thread end the reading, checked at coarse intervals. */
final class Interrupts {
  private Interrupts() {}

  /**
   * Checks whether the current thread is interrupted, and leaves its interrupt status as it is.
   *
   * @throws CancellationException if it is
   */
  static void check() {
    if (Thread.currentThread().isInterrupted()) {
      throw new CancellationException("reading the scene was interrupted");
    }
  }

  /** Returns a stream over bytes that makes this check whenever a block is read. */
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
