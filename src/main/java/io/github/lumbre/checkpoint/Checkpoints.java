package io.github.lumbre.checkpoint;

import io.github.lumbre.render.Film;
import io.github.lumbre.render.Progress;
import java.time.Duration;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * Saves the film of a running render: once in an interval. A pass over the film is cancelled for it
 * wherever it is, and made up for by the next, so that long passes do not put it off. Rendering
 * waits until the film is copied, and continues while another thread saves the copy. There is one
 * save at a time: if one takes longer than the interval, the next begins when it has ended.
 *
 * <p>{@link #pausing} is for the render's threads, all else for the one that starts their passes.
 */
public final class Checkpoints {
  private final long intervalNanos;
  private final boolean copies;
  private volatile long next;
  private volatile Optional<BackgroundSave> running = Optional.empty();
  private Optional<Film> copy = Optional.empty();

  /**
   * @param copies whether there is memory for a second film; if not, rendering waits for each save
   */
  public Checkpoints(Duration interval, boolean copies) {
    this.intervalNanos = interval.toNanos();
    this.copies = copies;
    next = System.nanoTime() + intervalNanos;
  }

  /** Returns a listener that cancels a pass when the film is to be saved, or the other does. */
  public Progress pausing(Progress listener) {
    return listener.cancelledAlsoIf(this::isDue);
  }

  private boolean isDue() {
    return System.nanoTime() - next >= 0 && !running.map(BackgroundSave::isRunning).orElse(false);
  }

  /**
   * Saves a film if the interval is over; called between passes.
   *
   * @param saver saves the film it is given, which nobody changes meanwhile; called in one thread
   *     at a time
   * @throws IllegalStateException if the save before ended by an exception
   */
  public void saveIfDue(Film film, Consumer<Film> saver) {
    if (!isDue()) {
      return;
    }
    next = System.nanoTime() + intervalNanos;
    if (copies) {
      await();
      Film content = copied(film);
      running = Optional.of(BackgroundSave.start(() -> saver.accept(content)));
    } else {
      saver.accept(film);
    }
  }

  private Film copied(Film film) {
    if (copy.isPresent()) {
      copy.get().set(film);
    } else {
      copy = Optional.of(film.copy());
    }
    return copy.get();
  }

  /**
   * Saves a film now, after the save that is running, if one is.
   *
   * @param saver saves the film it is given
   * @throws IllegalStateException if the save before ended by an exception; this one is done all
   *     the same
   */
  public void saveLast(Film film, Consumer<Film> saver) {
    try {
      await();
    } finally {
      copy = Optional.empty();
      saver.accept(film);
    }
  }

  private void await() {
    Optional<BackgroundSave> before = running;
    running = Optional.empty();
    before.ifPresent(BackgroundSave::await);
  }
}
