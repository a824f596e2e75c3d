package io.github.lumbre.render;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/** Starts a thread for each worker, and watches them for stalled buckets. Stateless. */
final class OwnThreads implements Crew {
  private static final long SECONDS_PER_LOOK = 5;

  @Override
  public void run(List<BucketWorker> workers, RenderQueue queue, Progress progress)
      throws InterruptedException {
    List<Thread> threads = new ArrayList<>();
    ExecutorService pool =
        Executors.newFixedThreadPool(
            workers.size(),
            task -> {
              Thread thread = new Thread(task, "lumbre-render-" + (threads.size() + 1));
              thread.setDaemon(true);
              threads.add(thread);
              return thread;
            });
    try {
      List<Future<?>> futures = new ArrayList<>();
      workers.forEach(worker -> futures.add(pool.submit(worker)));
      Watchdog watchdog = new Watchdog(workers, seconds(), progress);
      for (Future<?> future : futures) {
        await(future, watchdog);
      }
    } catch (ExecutionException e) {
      throw Crew.failure(e.getCause());
    } finally {
      queue.stop();
      pool.shutdown();
      awaitEnd(threads);
    }
  }

  private static void await(Future<?> future, Watchdog watchdog)
      throws InterruptedException, ExecutionException {
    while (true) {
      try {
        future.get(SECONDS_PER_LOOK, TimeUnit.SECONDS);
        return;
      } catch (TimeoutException e) {
        watchdog.look(seconds());
      }
    }
  }

  private static double seconds() {
    return System.nanoTime() * 1e-9;
  }

  /** Waits for the threads, which end shortly, and restores the interrupt status. */
  private static void awaitEnd(List<Thread> threads) {
    boolean interrupted = Thread.interrupted();
    for (Thread thread : threads) {
      while (thread.isAlive()) {
        try {
          thread.join();
        } catch (InterruptedException e) {
          interrupted = true;
        }
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
