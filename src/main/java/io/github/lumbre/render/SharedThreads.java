package io.github.lumbre.render;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;

/**
 * Runs one worker in the calling thread and offers the others to an executor. Workers that the
 * executor has not started by the end of the pass are withdrawn, so a pass never waits for a busy
 * pool, even if the calling thread is one of its threads. Stalled buckets are not reported.
 * Immutable.
 */
record SharedThreads(Executor executor) implements Crew {
  /** A worker that is either run by a thread of the pool, or withdrawn. */
  private static final class Offer implements Runnable {
    private final BucketRenderer worker;
    private final AtomicReference<Throwable> failure;
    private final AtomicBoolean taken = new AtomicBoolean();
    private final CountDownLatch ended = new CountDownLatch(1);

    Offer(BucketRenderer worker, AtomicReference<Throwable> failure) {
      this.worker = worker;
      this.failure = failure;
    }

    @Override
    public void run() {
      if (taken.compareAndSet(false, true)) {
        try {
          Crew.attempt(worker, failure);
        } finally {
          ended.countDown();
        }
      }
    }

    /** Withdraws the offer, or waits for the end of its worker; restores the interrupt status. */
    void end() {
      if (!taken.compareAndSet(false, true)) {
        Crew.await(ended::await);
      }
    }
  }

  @Override
  public int pilotThreads(int wanted) {
    return 0;
  }

  @Override
  public void run(List<BucketRenderer> workers, RenderQueue queue, Progress progress)
      throws InterruptedException {
    queue.stopIfInterrupted(Thread.currentThread());
    AtomicReference<Throwable> failure = new AtomicReference<>();
    List<Offer> offers = new ArrayList<>();
    try {
      for (BucketRenderer worker : workers.subList(1, workers.size())) {
        Offer offer = new Offer(worker, failure);
        offers.add(offer);
        executor.execute(offer);
      }
    } catch (RejectedExecutionException e) {
      // The pool has no thread to spare: the threads that it has given so far render alone.
    }
    try {
      Crew.attempt(workers.get(0), failure);
    } finally {
      if (failure.get() != null || Thread.currentThread().isInterrupted()) {
        queue.stop();
      }
      offers.forEach(Offer::end);
    }
    Crew.requireNone(failure);
    if (!queue.isExhausted() && Thread.interrupted()) {
      throw new InterruptedException("rendering was interrupted");
    }
  }
}
