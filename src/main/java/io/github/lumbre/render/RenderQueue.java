package io.github.lumbre.render;

import io.github.lumbre.scene.RenderSettings.Crop;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;

/** The remaining buckets of a pass, and whether the workers should stop. All workers share it. */
final class RenderQueue {
  private final List<Crop> buckets;
  private final Progress progress;
  private volatile Optional<Thread> owner = Optional.empty();
  private final AtomicInteger next = new AtomicInteger();
  private final AtomicInteger finished = new AtomicInteger();
  private final AtomicBoolean stopped = new AtomicBoolean();

  RenderQueue(List<Crop> buckets, Progress progress) {
    this.buckets = List.copyOf(buckets);
    this.progress = progress;
  }

  /** Takes the next bucket; empty if there is none left. */
  Optional<Crop> take() {
    // The counter stops near the end, so it cannot overflow.
    int number = next.get() < buckets.size() ? next.getAndIncrement() : buckets.size();
    return number < buckets.size() ? Optional.of(buckets.get(number)) : Optional.empty();
  }

  void finish(Crop bucket) {
    finished.incrementAndGet();
    progress.finished(bucket);
  }

  void advance(long samples) {
    progress.advanced(samples);
  }

  /** Makes all workers stop soon after a thread is interrupted. */
  void stopIfInterrupted(Thread thread) {
    owner = Optional.of(thread);
  }

  /** Makes all workers stop soon. */
  void stop() {
    stopped.set(true);
  }

  boolean isStopped() {
    return stopped.get()
        || owner.isPresent() && owner.get().isInterrupted()
        || progress.isCancelled();
  }

  /** Returns whether all buckets are finished. */
  boolean isExhausted() {
    return finished.get() == buckets.size();
  }
}
