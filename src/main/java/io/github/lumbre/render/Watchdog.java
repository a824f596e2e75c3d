package io.github.lumbre.render;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Notices workers whose samples do not end. Whoever waits for the workers looks now and then, so no
 * thread and nothing in a sample's way is needed. Mutable, for one thread.
 */
final class Watchdog {
  /** After so long without an end of 16 samples, a worker is called stalled for the first time. */
  static final double PATIENCE_SECONDS = 60;

  /** What is known of a worker. */
  private static final class Watched {
    private final BucketWorker worker;
    private long beats;
    private double since;
    private double patience = PATIENCE_SECONDS;

    private Watched(BucketWorker worker, double now) {
      this.worker = worker;
      beats = worker.beats();
      since = now;
    }

    private void look(double now, Progress progress) {
      Optional<Bucket> bucket = worker.bucket();
      if (worker.beats() != beats || bucket.isEmpty()) {
        beats = worker.beats();
        since = now;
        patience = PATIENCE_SECONDS;
      } else if (now - since >= patience) {
        progress.stalled(bucket.get(), now - since);
        patience *= 2;
      }
    }
  }

  private final List<Watched> watched = new ArrayList<>();
  private final Progress progress;

  /**
   * @param now seconds of any clock that never goes back
   * @param progress hears of each stalled bucket after a minute, two, four and so on
   */
  Watchdog(List<BucketWorker> workers, double now, Progress progress) {
    workers.forEach(worker -> watched.add(new Watched(worker, now)));
    this.progress = progress;
  }

  void look(double now) {
    watched.forEach(one -> one.look(now, progress));
  }
}
