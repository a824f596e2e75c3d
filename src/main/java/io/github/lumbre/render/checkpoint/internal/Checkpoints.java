package io.github.lumbre.render.checkpoint.internal;

import io.github.lumbre.render.Film;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.Consumer;

/**
 * Saves the film of a running render at regular intervals. Rendering pauses while the film is
 * copied, and continues while another thread saves the copy. Saves never overlap: if one takes
 * longer than the interval, the next starts when it has ended.
 *
 * <p>All threads of the render may call {@link #isDue}. The other methods are for the thread that
 * starts its passes.
 */
public final class Checkpoints {
  private final long intervalNanos;
  private final boolean copies;
  private volatile long next;
  private volatile Optional<CompletableFuture<Void>> running = Optional.empty();
  private Optional<Film> copy = Optional.empty();

  /**
   * Creates a scheduler whose first save is due after one interval.
   *
   * @param interval time between the starts of two saves
   * @param copies whether there is memory for a second film; if not, rendering waits for each save
   */
  public Checkpoints(Duration interval, boolean copies) {
    this.intervalNanos = interval.toNanos();
    this.copies = copies;
    next = System.nanoTime() + intervalNanos;
  }

  /** Returns whether a save is due, for which the current pass should pause. */
  public boolean isDue() {
    return System.nanoTime() - next >= 0 && running.map(CompletableFuture::isDone).orElse(true);
  }

  /**
   * Saves a film if a save is due; called between passes.
   *
   * @param saver saves the film that it receives, which does not change meanwhile; never called by
   *     two threads at the same time
   * @throws IllegalStateException if the previous save threw an exception
   */
  public void saveIfDue(Film film, Consumer<Film> saver) {
    if (!isDue()) {
      return;
    }
    next = System.nanoTime() + intervalNanos;
    if (copies) {
      await();
      Film content = copied(film);
      running =
          Optional.of(CompletableFuture.runAsync(() -> saver.accept(content), Checkpoints::start));
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
   * Saves a film now, after any running save has ended.
   *
   * @param saver saves the film that it receives
   * @throws IllegalStateException if the previous save threw an exception; this film is saved
   *     nevertheless
   */
  public void saveLast(Film film, Consumer<Film> saver) {
    try {
      await();
    } finally {
      copy = Optional.empty();
      saver.accept(film);
    }
  }

  /** Starts a thread that gives way to rendering. */
  private static void start(Runnable save) {
    Thread thread = new Thread(save, "lumbre-checkpoint");
    thread.setDaemon(true);
    thread.setPriority(Thread.MIN_PRIORITY);
    thread.start();
  }

  /** Waits until the running save has ended, even if this thread is interrupted meanwhile. */
  private void await() {
    Optional<CompletableFuture<Void>> before = running;
    running = Optional.empty();
    try {
      before.ifPresent(CompletableFuture::join);
    } catch (CompletionException e) {
      throw new IllegalStateException("a checkpoint failed: " + e.getCause(), e.getCause());
    }
  }
}
