package io.github.lumbre.model;

import java.util.concurrent.CancellationException;

/** Stops the reading of a model when its thread is interrupted; checks at coarse intervals. */
final class Interrupts {
  private Interrupts() {}

  /**
   * Checks whether the current thread is interrupted. The interrupt status stays unchanged.
   *
   * @throws CancellationException if the thread is interrupted
   */
  static void check() {
    if (Thread.currentThread().isInterrupted()) {
      throw new CancellationException("reading the model was interrupted");
    }
  }
}
