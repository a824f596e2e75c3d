package io.github.lumbre.model;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.util.concurrent.CancellationException;

/** Stops the reading of a glTF file when its thread is interrupted; checks at coarse intervals. */
final class GltfInterrupts {
  private GltfInterrupts() {}

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

  /** Returns a stream over bytes that calls {@link #check} before it reads a block. */
  static InputStream over(byte[] bytes, int offset, int length) {
    return new ByteArrayInputStream(bytes, offset, length) {
      @Override
      public synchronized int read(byte[] target, int to, int count) {
        check();
        return super.read(target, to, count);
      }
    };
  }
}
