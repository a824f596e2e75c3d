package io.github.lumbre.render.denoise.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;

/** Computes the rows of a picture on several threads. Stateless. */
final class Rows {
  private Rows() {}

  /** Computes rows; each thread has one of its own. */
  @FunctionalInterface
  interface Work {
    void compute(int row);
  }

  /** Creates the work of a thread. */
  @FunctionalInterface
  interface Worker {
    Work begin();
  }

  /**
   * Computes all rows, and returns when that is done.
   *
   * @throws InterruptedException if the calling thread is interrupted; no thread goes on then
   */
  static void compute(int rows, int threads, Worker worker) throws InterruptedException {
    AtomicInteger next = new AtomicInteger();
    AtomicBoolean isStopped = new AtomicBoolean();
    AtomicReference<Throwable> failure = new AtomicReference<>();
    Runnable task =
        () -> {
          Work work = worker.begin();
          for (int row; (row = next.getAndIncrement()) < rows && !isStopped.get(); ) {
            work.compute(row);
          }
        };
    List<Thread> started = new ArrayList<>();
    for (int i = 0; i < Math.min(threads, rows); i++) {
      Thread thread = new Thread(task, "denoise");
      thread.setDaemon(true);
      thread.setUncaughtExceptionHandler((failed, cause) -> failure.compareAndSet(null, cause));
      thread.start();
      started.add(thread);
    }
    try {
      for (Thread thread : started) {
        thread.join();
      }
    } finally {
      isStopped.set(true);
    }
    if (failure.get() instanceof Error error) {
      throw error;
    }
    if (failure.get() != null) {
      throw new IllegalStateException(failure.get());
    }
  }

  /** Computes one pixel, which has a number: row by row, from the top left. */
  @FunctionalInterface
  interface OfPixel {
    void compute(int pixel);
  }

  /** Computes all pixels of a picture, as {@link #compute} does. */
  static void forEach(int width, int height, int threads, OfPixel work)
      throws InterruptedException {
    compute(
        height,
        threads,
        () ->
            y -> {
              for (int pixel = y * width; pixel < (y + 1) * width; pixel++) {
                work.compute(pixel);
              }
            });
  }
}
