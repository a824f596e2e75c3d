package io.github.lumbre.cli;

import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;

/**
 * Lets SIGINT and SIGTERM end a render early instead of losing it: the virtual machine's end is
 * held up until the render has stopped and the picture is saved. A second signal ends it at once.
 * Shared by the render's threads and the one that ends the virtual machine.
 */
final class Interruption implements AutoCloseable {
  /** What has been closed while the program was to end, but may still have to tell why. */
  private static final Queue<Interruption> ENDING = new ConcurrentLinkedQueue<>();

  private final CountDownLatch ended = new CountDownLatch(1);

  private final Thread hook = new Thread(this::hold, "lumbre-interruption");
  private final Runnable abandon;
  private boolean rendering;
  private volatile boolean requested;

  private Interruption(Runnable abandon) {
    this.abandon = abandon;
  }

  /**
   * Begins to listen.
   *
   * @param abandon what to do if the virtual machine ends before the render began
   */
  static Interruption listen(Runnable... abandon) {
    Interruption interruption = new Interruption(() -> List.of(abandon).forEach(Runnable::run));
    Runtime.getRuntime().addShutdownHook(interruption.hook);
    return interruption;
  }

  /** Holds up the program's end no longer: all is told. */
  static void letEnd() {
    ENDING.forEach(interruption -> interruption.ended.countDown());
  }

  /** Tells whether the program is to end. */
  boolean isRequested() {
    return requested;
  }

  /** From now on there is something to save; returns false if the program is ending already. */
  synchronized boolean beginRender() {
    rendering = !requested;
    return rendering;
  }

  /**
   * All is saved, or nothing can be: the program may end as soon as it has told so, see {@link
   * #letEnd}.
   */
  @Override
  public void close() {
    if (requested) {
      ENDING.add(this);
      return;
    }
    ended.countDown();
    try {
      Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      // The virtual machine has begun to end just now; the hook will find nothing to wait for.
      return;
    }
  }

  private void hold() {
    if (!request()) {
      return;
    }
    Signals.on("INT", () -> Runtime.getRuntime().halt(ExitCodes.INTERRUPTED));
    Signals.on("TERM", () -> Runtime.getRuntime().halt(ExitCodes.TERMINATED));
    try {
      ended.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Asks the render to stop; returns whether there is one to wait for. */
  private synchronized boolean request() {
    requested = true;
    if (!rendering && ended.getCount() != 0) {
      abandon.run();
    }
    return rendering;
  }
}
