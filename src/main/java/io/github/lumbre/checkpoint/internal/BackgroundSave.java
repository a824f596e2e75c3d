package io.github.lumbre.checkpoint.internal;

import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;

/**
 * A save in a background thread, which ends when the save has ended. Used by the thread that
 * started it.
 */
final class BackgroundSave {
  private final FutureTask<Void> task;
  private final Thread thread;

  private BackgroundSave(Runnable save) {
    task = new FutureTask<>(save, null);
    thread = new Thread(task, "lumbre-checkpoint");
    thread.setDaemon(true);
    thread.setPriority(Thread.MIN_PRIORITY);
  }

  static BackgroundSave start(Runnable save) {
    BackgroundSave started = new BackgroundSave(save);
    started.thread.start();
    return started;
  }

  /** Returns whether the save is running; callable from any thread. */
  boolean isRunning() {
    return !task.isDone();
  }

  /**
   * Waits until the save has ended. If the calling thread is interrupted meanwhile, its interrupt
   * status is set on return.
   *
   * @throws IllegalStateException if the save threw an exception
   */
  void await() {
    boolean interrupted = false;
    while (thread.isAlive()) {
      try {
        thread.join();
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
    try {
      task.get();
    } catch (ExecutionException e) {
      throw new IllegalStateException("a checkpoint failed: " + e.getCause(), e.getCause());
    } catch (InterruptedException e) {
      interrupted = true;
    } finally {
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }
}
