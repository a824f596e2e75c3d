package io.github.lumbre.render;

import io.github.lumbre.scene.RenderSettings;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;

/**
 * Renders the rows of a pilot.
 *
 * @param threads number of threads to start; 0 renders in the calling thread
 * @param isStopped whether the pilot must end; called by all threads
 */
record PilotRows(int threads, BooleanSupplier isStopped) {
  /** Renders in the calling thread. */
  static final PilotRows HERE = new PilotRows(0, () -> false);

  /** Returns rows on as many threads as the settings allow. */
  static PilotRows of(RenderSettings settings) {
    return new PilotRows(threads(settings), () -> false);
  }

  static int threads(RenderSettings settings) {
    return settings.threads() == 0
        ? Runtime.getRuntime().availableProcessors()
        : settings.threads();
  }

  /** Renders a row, for one thread. */
  interface Row<T> {
    T render(int row) throws InterruptedException;
  }

  /**
   * Checks whether to go on; rows call this before each pixel.
   *
   * @throws CancellationException if the pilot is stopped
   */
  void check() throws InterruptedException {
    if (Thread.interrupted()) {
      throw new InterruptedException("the pilot render was interrupted");
    }
    if (isStopped.getAsBoolean()) {
      throw new CancellationException("the pilot render was stopped");
    }
  }

  /**
   * Renders all rows and returns them in order.
   *
   * @throws InterruptedException if the calling thread is interrupted; all threads have then ended
   * @throws CancellationException if the pilot was stopped; all threads have then ended
   * @throws RenderException if a row failed
   */
  <T> List<T> render(int rows, Row<T> row) throws InterruptedException {
    List<T> done = new ArrayList<>();
    if (threads == 0) {
      for (int number = 0; number < rows; number++) {
        done.add(row.render(number));
      }
      return done;
    }
    ExecutorService pool =
        Executors.newFixedThreadPool(
            Math.min(threads, rows),
            task -> {
              Thread thread = new Thread(task, "lumbre-pilot");
              thread.setDaemon(true);
              return thread;
            });
    try {
      List<Callable<T>> tasks = new ArrayList<>();
      IntStream.range(0, rows).forEach(number -> tasks.add(() -> row.render(number)));
      for (Future<T> result : pool.invokeAll(tasks)) {
        done.add(result.get());
      }
      return done;
    } catch (ExecutionException e) {
      if (e.getCause() instanceof CancellationException stopped) {
        throw stopped;
      }
      throw Crew.failure(e.getCause());
    } finally {
      pool.shutdownNow();
      Crew.await(() -> pool.awaitTermination(Long.MAX_VALUE, TimeUnit.NANOSECONDS));
    }
  }
}
