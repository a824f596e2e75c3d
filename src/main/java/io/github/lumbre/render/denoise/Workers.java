package io.github.lumbre.render.denoise;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;

/** Threads that compute strips of rows. */
final class Workers implements AutoCloseable {
  private static final int HIGHEST_STRIP = 32;
  private static final int LOWEST_STRIP = 8;

  /** Computes the rows of a strip. */
  interface Strip {
    /**
     * @param first the first row, an even number
     * @param end after the last row
     * @param convolution of this thread
     */
    void compute(int first, int end, Convolution convolution);
  }

  private final int threads;
  private final ExecutorService pool;
  private final List<Convolution> convolutions = new ArrayList<>();

  Workers(int threads) {
    this.threads = threads;
    pool = Executors.newFixedThreadPool(threads, Workers::daemon);
    for (int i = 0; i < threads; i++) {
      convolutions.add(new Convolution(ScalarConvolution.isUsed()));
    }
  }

  private static Thread daemon(Runnable task) {
    Thread thread = new Thread(task, "denoise");
    thread.setDaemon(true);
    return thread;
  }

  /**
   * Computes all rows, and returns when that is done.
   *
   * @throws InterruptedException if the calling thread is interrupted
   */
  void compute(int rows, Strip strip) throws InterruptedException {
    int share = (rows / (2 * threads) + 1) / 2 * 2;
    int height = Math.max(LOWEST_STRIP, Math.min(HIGHEST_STRIP, share));
    AtomicInteger next = new AtomicInteger();
    List<Future<?>> running = new ArrayList<>();
    for (Convolution convolution : convolutions) {
      running.add(
          pool.submit(
              () -> {
                for (int y; (y = next.getAndAdd(height)) < rows && !Thread.interrupted(); ) {
                  strip.compute(y, Math.min(rows, y + height), convolution);
                }
              }));
    }
    for (Future<?> worker : running) {
      finish(worker);
    }
  }

  private static void finish(Future<?> worker) throws InterruptedException {
    try {
      worker.get();
    } catch (ExecutionException e) {
      if (e.getCause() instanceof Error error) {
        throw error;
      }
      throw new IllegalStateException(e.getCause());
    }
  }

  @Override
  public void close() {
    pool.shutdownNow();
  }
}
