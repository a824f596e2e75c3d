package io.github.lumbre.render;

import java.util.List;
import java.util.concurrent.atomic.AtomicReference;

/** The threads that run the workers of a pass. */
interface Crew {
  /**
   * Runs workers until the queue is exhausted or stopped. No worker runs any more when it returns
   * or throws.
   *
   * @throws InterruptedException if the calling thread is interrupted
   * @throws RenderException if a worker failed
   */
  void run(List<BucketRenderer> workers, RenderQueue queue, Progress progress)
      throws InterruptedException;

  /**
   * Returns the number of own threads that may render the pilot; 0 for the calling thread alone.
   *
   * @param wanted threads of a pass
   */
  default int pilotThreads(int wanted) {
    return wanted;
  }

  /** Runs a worker and keeps the first failure; workers stop the queue when they fail. */
  static void attempt(BucketRenderer worker, AtomicReference<Throwable> failure) {
    try {
      worker.run();
    } catch (RuntimeException | Error e) {
      failure.compareAndSet(null, e);
    }
  }

  /** Throws the exception for the failure of a worker, if there is one. */
  static void requireNone(AtomicReference<Throwable> failure) {
    if (failure.get() != null) {
      throw failure(failure.get());
    }
  }

  static RenderException failure(Throwable cause) {
    return new RenderException("rendering failed: " + cause, cause);
  }

  interface Wait {
    void await() throws InterruptedException;
  }

  /** Waits for something that comes shortly, and restores the interrupt status at the end. */
  static void await(Wait wait) {
    boolean interrupted = false;
    while (true) {
      try {
        wait.await();
        break;
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
