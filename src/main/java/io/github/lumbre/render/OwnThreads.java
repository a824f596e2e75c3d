package io.github.lumbre.render;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;

/** Starts a thread for each worker, and watches them for stalled buckets. Stateless. */
final class OwnThreads implements Crew {
  private static final long MILLIS_PER_LOOK = 5000;

  @Override
  public void run(List<BucketRenderer> workers, RenderQueue queue, Progress progress)
      throws InterruptedException {
    AtomicReference<Throwable> failure = new AtomicReference<>();
    List<Thread> threads = new ArrayList<>();
    try {
      for (BucketRenderer worker : workers) {
        Thread thread =
            new Thread(
                () -> Crew.attempt(worker, failure), "lumbre-render-" + (threads.size() + 1));
        thread.setDaemon(true);
        thread.start();
        threads.add(thread);
      }
      Watchdog watchdog = new Watchdog(workers, seconds(), progress);
      for (Thread thread : threads) {
        for (thread.join(MILLIS_PER_LOOK); thread.isAlive(); thread.join(MILLIS_PER_LOOK)) {
          watchdog.look(seconds());
        }
      }
    } finally {
      queue.stop();
      threads.forEach(thread -> Crew.await(thread::join));
    }
    Crew.requireNone(failure);
  }

  private static double seconds() {
    return System.nanoTime() * 1e-9;
  }
}
