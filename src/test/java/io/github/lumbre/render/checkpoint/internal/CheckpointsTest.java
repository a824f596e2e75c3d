package io.github.lumbre.render.checkpoint.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.render.Film;
import io.github.lumbre.render.checkpoint.FilmFixture;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Tests when checkpoints are saved while a render continues. */
@Timeout(60)
class CheckpointsTest {
  private final List<byte[]> saved = Collections.synchronizedList(new ArrayList<>());
  private final List<Thread> savers = Collections.synchronizedList(new ArrayList<>());
  private final AtomicInteger atOnce = new AtomicInteger();

  /** The number of saves that may end. */
  private final Semaphore disk = new Semaphore(0);

  private static Film film(int samples) {
    return FilmFixture.file(FilmFixture.FRAME, 0, (x, y) -> samples).film();
  }

  private Checkpoints always(boolean copies) {
    return new Checkpoints(Duration.ZERO, copies);
  }

  private void save(Film film) {
    assertThat(atOnce.incrementAndGet()).isEqualTo(1);
    savers.add(Thread.currentThread());
    disk.acquireUninterruptibly();
    saved.add(FilmFixture.pixels(film));
    atOnce.decrementAndGet();
  }

  @Test
  void filmGrowsWhileWhatItWasIsSaved() {
    Checkpoints checkpoints = always(true);
    Film film = film(1);
    checkpoints.saveIfDue(film, this::save);
    film.set(film(2));
    disk.release(2);
    checkpoints.saveLast(film, this::save);
    assertThat(saved).containsExactly(FilmFixture.pixels(film(1)), FilmFixture.pixels(film(2)));
    assertThat(savers.get(0)).isNotEqualTo(Thread.currentThread());
    assertThat(savers.get(1)).isEqualTo(Thread.currentThread());
  }

  @Test
  void renderingIsNotPausedForASaveThatWouldHaveToWait() throws InterruptedException {
    Checkpoints checkpoints = always(true);
    assertThat(checkpoints.isDue()).isTrue();
    checkpoints.saveIfDue(film(1), this::save);
    assertThat(checkpoints.isDue()).isFalse();
    checkpoints.saveIfDue(film(2), this::save);
    disk.release();
    while (!checkpoints.isDue()) {
      Thread.sleep(1);
    }
    checkpoints.saveIfDue(film(3), this::save);
    disk.release(2);
    checkpoints.saveLast(film(4), this::save);
    assertThat(saved)
        .containsExactly(
            FilmFixture.pixels(film(1)), FilmFixture.pixels(film(3)), FilmFixture.pixels(film(4)));
  }

  @Test
  void lastSaveComesAfterTheOneBeforeEvenIfInterrupted() throws InterruptedException {
    Checkpoints checkpoints = always(true);
    checkpoints.saveIfDue(film(1), this::save);
    Thread.currentThread().interrupt();
    new Thread(() -> disk.release(2)).start();
    checkpoints.saveLast(film(2), this::save);
    assertThat(Thread.interrupted()).isTrue();
    assertThat(saved).hasSize(2);
    savers.get(0).join(10_000);
    assertThat(savers.get(0).isAlive()).isFalse();
  }

  @Test
  void intervalIsKept() {
    Checkpoints checkpoints = new Checkpoints(Duration.ofHours(1), true);
    checkpoints.saveIfDue(film(1), this::save);
    assertThat(checkpoints.isDue()).isFalse();
    assertThat(savers).isEmpty();
  }

  @Test
  void withoutMemoryForACopyRenderingWaits() {
    Checkpoints checkpoints = always(false);
    disk.release();
    checkpoints.saveIfDue(film(1), this::save);
    assertThat(savers).containsExactly(Thread.currentThread());
  }

  /**
   * An exception of the saver is a program error: it ends the render, after a last attempt to save.
   */
  @Test
  void faultsOfTheThreadThatSavesAreTold() {
    List<Integer> samples = new ArrayList<>();
    Checkpoints checkpoints = always(true);
    checkpoints.saveIfDue(
        film(1),
        film -> {
          throw new OutOfMemoryError("planted");
        });
    assertThatThrownBy(() -> checkpoints.saveLast(film(2), film -> samples.add(film.mostSamples())))
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("planted")
        .hasRootCauseInstanceOf(OutOfMemoryError.class);
    assertThat(samples).containsExactly(2);
  }

  /** On a machine with any load, saves begin at least an interval apart. */
  @Test
  void savesAreAnIntervalApart() throws InterruptedException {
    Duration interval = Duration.ofMillis(200);
    long start = System.nanoTime();
    Checkpoints checkpoints = new Checkpoints(interval, false);
    disk.release(3);
    for (int i = 0; i < 3; i++) {
      while (!checkpoints.isDue()) {
        Thread.sleep(1);
      }
      assertThat(System.nanoTime() - start).isGreaterThanOrEqualTo(interval.toNanos());
      start = System.nanoTime();
      checkpoints.saveIfDue(film(1), this::save);
    }
    assertThat(saved).hasSize(3);
  }

  @Test
  void savesNeitherKeepTheProgramAliveNorPressOnRendering() {
    Checkpoints checkpoints = always(true);
    disk.release(2);
    checkpoints.saveIfDue(
        film(1),
        film -> {
          assertThat(Thread.currentThread().isDaemon()).isTrue();
          assertThat(Thread.currentThread().getPriority()).isLessThan(Thread.NORM_PRIORITY);
          save(film);
        });
    checkpoints.saveLast(film(2), this::save);
    assertThat(saved).hasSize(2);
  }

  /** The first save ends before the second film overwrites the first one's copy. */
  @Test
  void eachSaveHasTheFilmAsItWas() throws InterruptedException {
    Checkpoints checkpoints = always(true);
    disk.release(5);
    for (int samples = 1; samples <= 4; samples++) {
      checkpoints.saveIfDue(film(samples), this::save);
      while (!checkpoints.isDue()) {
        Thread.sleep(1);
      }
    }
    checkpoints.saveLast(film(5), this::save);
    for (int samples = 1; samples <= 5; samples++) {
      assertThat(saved.get(samples - 1)).isEqualTo(FilmFixture.pixels(film(samples)));
    }
  }

  private static void awaitWaiting(Thread thread) {
    while (thread.getState() != Thread.State.WAITING) {
      Thread.onSpinWait();
    }
  }

  /** The save interrupts the render thread while that waits, and ends when it waits again. */
  @Test
  void interruptionsAreKeptUntilTheSaveHasEnded() {
    Thread render = Thread.currentThread();
    Checkpoints checkpoints = always(true);
    disk.release(2);
    checkpoints.saveIfDue(
        film(1),
        film -> {
          awaitWaiting(render);
          render.interrupt();
          while (render.isInterrupted()) {
            Thread.onSpinWait();
          }
          awaitWaiting(render);
          save(film);
        });
    checkpoints.saveLast(film(2), this::save);
    assertThat(Thread.interrupted()).isTrue();
    assertThat(saved).containsExactly(FilmFixture.pixels(film(1)), FilmFixture.pixels(film(2)));
  }

  @Test
  void savesThatEndWellInterruptNobody() {
    Checkpoints checkpoints = always(true);
    disk.release(2);
    checkpoints.saveIfDue(film(1), this::save);
    checkpoints.saveLast(film(2), this::save);
    assertThat(Thread.interrupted()).isFalse();
  }

  @Test
  void faultsOfASaveAreToldByTheNext() throws InterruptedException {
    Checkpoints checkpoints = always(true);
    checkpoints.saveIfDue(
        film(1),
        film -> {
          throw new IllegalArgumentException("planted");
        });
    while (!checkpoints.isDue()) {
      Thread.sleep(1);
    }
    assertThatThrownBy(() -> checkpoints.saveIfDue(film(2), this::save))
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("planted");
    assertThat(savers).isEmpty();
  }
}
