package io.github.lumbre.checkpoint;

import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;

/** A save in a thread of its own, which ends with it. For the thread that started it. */
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
   * Returns when it has ended; an interruption is kept for later.
   *
   * @throws IllegalStateException if it ended by an exception
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
