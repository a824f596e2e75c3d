package io.github.lumbre.render;

import io.github.lumbre.scene.RenderSettings.Crop;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Detects workers whose samples do not end. The thread that waits for the workers calls it
 * periodically, so it needs no thread of its own and costs the samples nothing. Mutable; confined
 * to one thread.
 */
final class Watchdog {
  /**
   * The time, in seconds, without progress by 16 samples after which a worker is first reported as
   * stalled.
   */
  static final double PATIENCE_SECONDS = 60;

  /** The last known state of a worker. */
  private static final class Watched {
    private final BucketRenderer worker;
    private long beats;
    private double since;
    private double patience = PATIENCE_SECONDS;

    private Watched(BucketRenderer worker, double now) {
      this.worker = worker;
      beats = worker.beats();
      since = now;
    }

    private void look(double now, Progress progress) {
      Optional<Crop> bucket = worker.bucket();
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
   * Creates a watchdog.
   *
   * @param now the time in seconds of any monotonic clock
   * @param progress receives each stalled bucket after 60 s, 120 s, 240 s and so on
   */
  Watchdog(List<BucketRenderer> workers, double now, Progress progress) {
    workers.forEach(worker -> watched.add(new Watched(worker, now)));
    this.progress = progress;
  }

  /**
   * Checks all workers.
   *
   * @param now the time in seconds of the same clock
   */
  void look(double now) {
    watched.forEach(one -> one.look(now, progress));
  }
}
