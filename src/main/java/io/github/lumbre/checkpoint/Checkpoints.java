package io.github.lumbre.checkpoint;

import io.github.lumbre.render.Bucket;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.Progress;
import java.time.Duration;
import java.util.function.Consumer;

/**
 * Says when a running render is to save its film: once in an interval. A pass over the film is
 * cancelled for it wherever it is, and made up for by the next, so that long passes do not put it
 * off. Shared by the render's threads; saving is its caller's.
 */
public final class Checkpoints {
  private final long intervalNanos;
  private final Consumer<Film> saver;
  private volatile long next;

  /**
   * @param saver saves the film it is given
   */
  public Checkpoints(Duration interval, Consumer<Film> saver) {
    this.intervalNanos = interval.toNanos();
    this.saver = saver;
    next = System.nanoTime() + intervalNanos;
  }

  /** Returns a listener that cancels a pass when the film is to be saved, or the other does. */
  public Progress pausing(Progress listener) {
    return new Progress() {
      @Override
      public void started(long totalSamples) {
        listener.started(totalSamples);
      }

      @Override
      public void advanced(long samples) {
        listener.advanced(samples);
      }

      @Override
      public void finished(Bucket bucket) {
        listener.finished(bucket);
      }

      @Override
      public boolean isCancelled() {
        return isDue() || listener.isCancelled();
      }
    };
  }

  private boolean isDue() {
    return System.nanoTime() - next >= 0;
  }

  /** Saves a film if the interval is over; called between passes. */
  public void saveIfDue(Film film) {
    if (isDue()) {
      saver.accept(film);
      next = System.nanoTime() + intervalNanos;
    }
  }
}
